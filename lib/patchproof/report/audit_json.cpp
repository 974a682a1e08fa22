#include <patchproof/report/audit_json.hpp>

namespace patchproof {

namespace {

Json counterexample_of(const AssumptionUse& use) {
  if (use.need != Need::necessary) return nullptr;
  Decision refuted;
  refuted.verdict = Verdict::refuted;
  refuted.witness = use.witness;
  return witness_of(refuted);
}

Json to_json(const ClaimAudit& claim) {
  Json uses = Json::array();
  for (const AssumptionUse& use : claim.uses)
    uses.push_back({{"assumption", use.name},
                    {"need", to_text(use.need)},
                    {"witness", counterexample_of(use)}});
  return {{"label", claim.label}, {"verb", claim.verb}, {"assumptions", std::move(uses)}};
}

Json to_json(const AssumptionAudit& assumption) {
  Json object;
  object["name"] = assumption.name;
  add_place(assumption.span, object);
  object["status"] = to_text(assumption.status);
  object["needed_by"] = assumption.needed_by;
  object["kept_by"] = assumption.kept_by;
  object["note"] = text_or_null(assumption.note);
  return object;
}

}  // namespace

Json to_json(const CaseAudit& audit) {
  Json claims = Json::array();
  for (const ClaimAudit& claim : audit.claims) claims.push_back(to_json(claim));
  Json assumptions = Json::array();
  for (const AssumptionAudit& assumption : audit.assumptions)
    assumptions.push_back(to_json(assumption));
  return {
      {"case", audit.name}, {"claims", std::move(claims)}, {"assumptions", std::move(assumptions)}};
}

}  // namespace patchproof
