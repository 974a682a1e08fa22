#include <nlohmann/json.hpp>

#include <patchproof/report/json_parts.hpp>
#include <patchproof/report/repair_report.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

std::string word_of(Repairs::Outcome outcome) {
  switch (outcome) {
    case Repairs::Outcome::found:
      return "found";
    case Repairs::Outcome::none:
      return "none";
    case Repairs::Outcome::stopped:
      return "stopped";
    case Repairs::Outcome::not_tried:
      return "not_tried";
    default:
      return "internal";
  }
}

Json changes_of(const Repair& repair, const std::string& printed) {
  Json changes = Json::array();
  for (const Edit& edit : repair.edits)
    changes.push_back({{"what", edit.what},
                       {"offset", edit.begin},
                       {"old", printed.substr(edit.begin, edit.end - edit.begin)},
                       {"new", edit.text}});
  return changes;
}

Json to_json(const Repairs& statement) {
  Json object;
  object["id"] = statement.id;
  add_place(statement.statement, object);
  object["instances"] = statement.instances;
  object["printed"] = statement.printed;
  object["outcome"] = word_of(statement.outcome);
  object["reason"] = text_or_null(statement.reason);
  object["complete"] = statement.complete;
  object["tried"] = statement.tried;
  Json repairs = Json::array();
  for (const Repair& repair : statement.repairs)
    repairs.push_back({{"text", repair.text},
                       {"changes", changes_of(repair, statement.printed)},
                       {"reversed", text_or_null(repair.reversed)},
                       {"verdict", to_text(repair.verdict)},
                       {"evidence", to_text(repair.evidence)},
                       {"conditions", repair.conditions}});
  object["repairs"] = std::move(repairs);
  return object;
}

}  // namespace

std::string json_of(const RepairReport& report) {
  Json document;
  document["version"] = version;
  document["statements"] = Json::array();
  for (const Repairs& statement : report.statements)
    document["statements"].push_back(to_json(statement));
  add_mistakes(record_of(Report{report.files, false}).files, document);
  document["exit"] = static_cast<int>(exit_code(report));
  return in_lines(document);
}

}  // namespace patchproof
