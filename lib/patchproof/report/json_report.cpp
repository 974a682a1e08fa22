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
  explicit DocumentWriter(const ReportSink& sink) : sink_{sink} {}

  void member(const std::string& name, const Json& value) {
    begin(name);
    sink_(inside(value, 1));
  }
  void begin_list(const std::string& name) {
    begin(name);
    sink_("[");
    empty_ = true;
  }
  void entry(const Json& value) {
    sink_((empty_ ? "\n    " : ",\n    ") + inside(value, 2));
    empty_ = false;
  }
  void end_list() { sink_(empty_ ? "]" : "\n  ]"); }
  void end() { sink_("\n}\n"); }

 private:
  void begin(const std::string& name) {
    sink_((started_ ? ",\n  \"" : "{\n  \"") + name + "\": ");
    started_ = true;
  }

  const ReportSink& sink_;
  bool started_ = false;
  bool empty_ = true;
};

void add_claims(const CaseRecord& of, bool is_shard, DocumentWriter& document) {
  for (const ClaimRecord& claim : of.claims) {
    Json object = to_json(claim, of.name);
    if (is_shard) object["position"] = claim.position;
    document.entry(object);
  }
}

}  // namespace

void json_report(const RunRecord& run, const ReportStyle& /*style*/, const ReportSink& sink) {
  DocumentWriter document{sink};
  document.member("version", version);
  document.member("strict", run.strict);
  if (run.shard)
    document.member("shard", {{"number", run.shard->number},
                              {"of", run.shard->of},
                              {"claims", run.shard->claims},
                              {"cases", run.shard->cases}});
  document.begin_list("claims");
  Json shown = Json::array();
  Json audits = Json::array();
  run.files.for_each([&](const FileRecord& file) {
    for (const CaseRecord& of : file.cases) {
      add_claims(of, run.shard.has_value(), document);
      for (const ShownRecord& term : of.shown) shown.push_back(to_json(term, of.name));
      if (of.audit) audits.push_back(Json::parse(of.audit->json));
    }
  });
  document.end_list();
  document.member("shown", shown);
  if (!audits.empty()) document.member("audits", audits);
  Json mistakes;
  add_mistakes(run.files, mistakes);
  for (const auto& [name, value] : mistakes.items()) document.member(name, value);
  document.member("summary", to_json(run.files.summary()));
  document.member("exit", static_cast<int>(exit_code(run)));
  document.end();
}

}  // namespace patchproof
