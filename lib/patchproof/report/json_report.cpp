#include <patchproof/report/json_report.hpp>

#include <patchproof/report/audit_json.hpp>
#include <patchproof/report/excerpt.hpp>
#include <patchproof/report/json_parts.hpp>
#include <patchproof/report/summary.hpp>
#include <patchproof/version.hpp>

namespace patchproof {

namespace {

Json to_json(const Subdivision& tree) {
  if (tree.boxes == 0) return nullptr;
  return {{"boxes", tree.boxes}, {"depth", tree.depth}};
}

Json to_json(const Case& of, const ClaimResult& result) {
  const Claim& claim = result.claim;
  const Decision& decision = result.decision;
  Json object;
  object["id"] = claim_id(of, claim);
  object["case"] = of.name;
  object["label"] = claim.label;
  object["instance"] = text_or_null(claim.instance);
  add_place(claim.span, object);
  object["verb"] = claim.verb;
  object["statement"] = as_written(claim.statement);
  object["expectation"] = to_text(claim.expectation);
  object["verdict"] = to_text(decision.verdict);
  object["as_expected"] = result.outcome == Outcome::as_expected;
  object["outcome"] = to_text(result.outcome);
  object["evidence"] = to_text(decision.evidence);
  object["certificate"] = text_or_null(decision.certificate);
  object["reason"] = text_or_null(decision.reason);
  object["conditions"] = decision.conditions;
  object["witness"] = witness_of(decision);
  object["subdivision"] = to_json(decision.subdivision);
  object["residual"] = text_or_null(decision.residual);
  object["assumptions_used"] = decision.assumptions_used;
  object["derived"] = named_values(decision.derived);
  object["free"] = decision.free;
  object["details"] = named_values(decision.details);
  object["note"] = text_or_null(claim.note);
  return object;
}

Json to_json(const JointReport& joint) {
  Json object;
  object["parametric"] = joint.parametric ? Json(*joint.parametric) : Json{};
  object["one_polynomial"] = joint.one_polynomial;
  object["geometric"] = joint.geometric ? Json(*joint.geometric) : Json{};
  object["next_parametric"] = text_or_null(joint.next_parametric);
  object["next_geometric"] = text_or_null(joint.next_geometric);
  object["conditions"] = joint.conditions;
  return object;
}

Json to_json(const Case& of, const ShownResult& shown) {
  Json object;
  object["case"] = of.name;
  object["instance"] = text_or_null(shown.instance);
  add_place(shown.span, object);
  object["term"] = shown.joint ? as_written(shown.joint->span) : shown.term;
  object["value"] = shown.value;
  if (shown.joint) object["joint"] = to_json(*shown.joint);
  return object;
}

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

std::string json_report(const Report& report, const ReportStyle& /*style*/) {
  Json claims = Json::array();
  Json shown = Json::array();
  for (const FileReport& file : report.files) {
    for (const CaseResult& result : file.cases) {
      for (const ClaimResult& claim : result.claims)
        claims.push_back(to_json(result.verified, claim));
      for (const ShownResult& term : result.shown) shown.push_back(to_json(result.verified, term));
    }
  }
  Json document;
  document["version"] = version;
  document["strict"] = report.strict;
  document["claims"] = std::move(claims);
  document["shown"] = std::move(shown);
  add_audits(report.files, document);
  add_mistakes(report.files, document);
  document["summary"] = to_json(summary_of(report));
  document["exit"] = static_cast<int>(exit_code(report));
  return in_lines(document);
}

}  // namespace patchproof
