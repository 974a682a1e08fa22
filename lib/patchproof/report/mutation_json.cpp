#include <nlohmann/json.hpp>

#include <patchproof/report/excerpt.hpp>
#include <patchproof/report/json_parts.hpp>
#include <patchproof/report/mutation_report.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

using Why = Mutant::Why;

std::string word_of(Fate fate) {
  switch (fate) {
    case Fate::noticed:
      return "noticed";
    case Fate::meaningless:
      return "meaningless";
    case Fate::survives:
      return "survives";
    case Fate::undecided:
      return "undecided";
    default:
      return "internal";
  }
}

std::string word_of(Site::Kind kind) {
  switch (kind) {
    case Site::Kind::claim:
      return "claim";
    case Site::Kind::declaration:
      return "declaration";
    case Site::Kind::data:
      return "data";
    default:
      return "definition";
  }
}

std::string word_of(Why why) {
  switch (why) {
    case Why::same:
      return "same";
    case Why::assumed:
      return "same_under_assumptions";
    case Why::data:
      return "data";
    case Why::independent:
      return "independent";
    default:
      return "";
  }
}

Json to_json(const Mutant& mutant) {
  const Edit& edit = mutant.change.error.edit;
  Json object;
  add_place(mutant.place, object);
  object["what"] = edit.what;
  object["change"] = mutant.change.error.words;
  object["offset"] = edit.begin;
  object["old"] = as_written(mutant.place);
  object["new"] = edit.text;
  object["fate"] = word_of(mutant.fate);
  object["why"] = text_or_null(word_of(mutant.why));
  object["data"] = mutant.data;
  object["differs_at"] = text_or_null(mutant.differs_at);
  return object;
}

Json to_json(const SiteMutants& site) {
  Json object;
  object["kind"] = word_of(site.kind);
  object["name"] = site.name;
  add_place(site.span, object);
  object["left_out"] = site.left_out;
  object["for_symbols"] = text_or_null(site.for_symbols);
  object["changes"] = Json::array();
  for (const Mutant& mutant : site.mutants) object["changes"].push_back(to_json(mutant));
  return object;
}

Json to_json(const BetterData& better) {
  return {{"data", better.words},
          {"for_symbols", better.for_symbols},
          {"noticed", better.noticed},
          {"other_values", better.other_values}};
}

Json to_json(const CaseMutation& of) {
  Json object;
  object["case"] = text_or_null(of.name);
  object["wrong"] = of.wrong;
  object["undecided"] = of.undecided;
  object["parts"] = Json::array();
  for (const SiteMutants& site : of.sites) object["parts"].push_back(to_json(site));
  object["shapes"] = of.shapes;
  object["hidden"] = of.hidden;
  object["better"] = Json::array();
  for (const BetterData& better : of.better) object["better"].push_back(to_json(better));
  return object;
}

}  // namespace

std::string json_of(const MutationReport& report) {
  Json document;
  document["version"] = version;
  document["cases"] = Json::array();
  for (const CaseMutation& of : report.cases) document["cases"].push_back(to_json(of));
  const MutationCount all = count_of(report);
  document["summary"] = {{"changes", all.tried},
                         {"noticed", all.noticed},
                         {"unnoticed", all.unnoticed},
                         {"same", all.same},
                         {"undecided", all.undecided}};
  add_mistakes(record_of(Report{report.files, false}).files, document);
  document["exit"] = static_cast<int>(exit_code(report));
  return in_lines(document);
}

}  // namespace patchproof
