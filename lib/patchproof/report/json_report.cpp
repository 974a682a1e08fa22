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

}  // namespace

std::string json_report(const RunRecord& run, const ReportStyle& /*style*/) {
  Json claims = Json::array();
  Json shown = Json::array();
  Json audits = Json::array();
  for (const FileRecord& file : run.files) {
    for (const CaseRecord& of : file.cases) {
      for (const ClaimRecord& claim : of.claims) {
        claims.push_back(to_json(claim, of.name));
        if (run.shard) claims.back()["position"] = claim.position;
      }
      for (const ShownRecord& term : of.shown) shown.push_back(to_json(term, of.name));
      if (of.audit) audits.push_back(Json::parse(of.audit->json));
    }
  }
  Json document;
  document["version"] = version;
  document["strict"] = run.strict;
  if (run.shard)
    document["shard"] = {{"number", run.shard->number},
                         {"of", run.shard->of},
                         {"claims", run.shard->claims},
                         {"cases", run.shard->cases}};
  document["claims"] = std::move(claims);
  document["shown"] = std::move(shown);
  if (!audits.empty()) document["audits"] = std::move(audits);
  add_mistakes(run.files, document);
  document["summary"] = to_json(summary_of(run));
  document["exit"] = static_cast<int>(exit_code(run));
  return in_lines(document);
}

}  // namespace patchproof
