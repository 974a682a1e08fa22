#include <patchproof/report/json_report.hpp>

#include <patchproof/report/claim_json.hpp>
#include <patchproof/report/summary.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

Json to_json(const Summary& summary) {
  Json object;
  object["cases"] = summary.cases;
  object["claims"] = summary.claims;
  for (const Outcome outcome : {Outcome::as_expected, Outcome::wrong, Outcome::unknown,
                                Outcome::vacuous, Outcome::error, Outcome::internal}) {
    const auto found = summary.outcomes.find(outcome);
    object[to_text(outcome)] = found == summary.outcomes.end() ? 0 : found->second;
  }
  object["conditional"] = summary.conditional;
  object["mistakes"] = summary.mistakes;
  object["unreadable"] = summary.unreadable_files;
  return object;
}

// The value as it is written inside of so many others; text has no line breaks of its own.
std::string inside(const Json& value, std::size_t depth) {
  const std::string text = value.dump(2, ' ', false, Json::error_handler_t::replace);
  std::string result;
  for (const char c : text) {
    result += c;
    if (c == '\n') result.append(2 * depth, ' ');
  }
  return result;
}

/// Writes a document member by member: all claims as one value would take several times the memory
/// of their text.
class DocumentWriter {
 public:
  void member(const std::string& name, const Json& value) {
    begin(name);
    text_ += inside(value, 1);
  }
  void begin_list(const std::string& name) {
    begin(name);
    text_ += "[";
    empty_ = true;
  }
  void entry(const Json& value) {
    text_ += (empty_ ? "\n    " : ",\n    ") + inside(value, 2);
    empty_ = false;
  }
  void end_list() { text_ += empty_ ? "]" : "\n  ]"; }
  std::string text() { return std::move(text_) + "\n}\n"; }

 private:
  void begin(const std::string& name) {
    text_ += (text_.empty() ? "{\n  \"" : ",\n  \"") + name + "\": ";
  }

  std::string text_;
  bool empty_ = true;
};

void add_claims(const RunRecord& run, DocumentWriter& document) {
  document.begin_list("claims");
  for (const FileRecord& file : run.files)
    for (const CaseRecord& of : file.cases)
      for (const ClaimRecord& claim : of.claims) {
        Json object = to_json(claim, of.name);
        if (run.shard) object["position"] = claim.position;
        document.entry(object);
      }
  document.end_list();
}

}  // namespace

std::string json_report(const RunRecord& run, const ReportStyle& /*style*/) {
  DocumentWriter document;
  document.member("version", version);
  document.member("strict", run.strict);
  if (run.shard)
    document.member("shard", {{"number", run.shard->number},
                              {"of", run.shard->of},
                              {"claims", run.shard->claims},
                              {"cases", run.shard->cases}});
  add_claims(run, document);
  Json shown = Json::array();
  Json audits = Json::array();
  for (const FileRecord& file : run.files)
    for (const CaseRecord& of : file.cases) {
      for (const ShownRecord& term : of.shown) shown.push_back(to_json(term, of.name));
      if (of.audit) audits.push_back(Json::parse(of.audit->json));
    }
  document.member("shown", shown);
  if (!audits.empty()) document.member("audits", audits);
  Json mistakes;
  add_mistakes(run.files, mistakes);
  for (const auto& [name, value] : mistakes.items()) document.member(name, value);
  document.member("summary", to_json(summary_of(run)));
  document.member("exit", static_cast<int>(exit_code(run)));
  return document.text();
}

}  // namespace patchproof
