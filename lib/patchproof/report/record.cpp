#include <patchproof/report/record.hpp>

#include <algorithm>

#include <patchproof/language/utf8.hpp>
#include <patchproof/report/audit_json.hpp>
#include <patchproof/report/audit_text.hpp>
#include <patchproof/report/excerpt.hpp>
#include <patchproof/report/finding.hpp>

namespace patchproof {

FilePlace place_at(const Span& span) {
  if (!span.source) return {};
  const Position position = position_of(*span.source, span.begin);
  return {span.source->name, position.line, position.column};
}

ClaimRecord record_of(const Case& of, const ClaimResult& result) {
  const Claim& claim = result.claim;
  ClaimRecord record{claim_id(of, claim),
                     claim.label,
                     claim.instance,
                     place_at(claim.span),
                     claim.verb,
                     as_written(claim.statement),
                     claim.expectation,
                     result.decision,
                     result.outcome,
                     claim.note,
                     needs_attention(result, true) ? finding(of, result) : "",
                     result.time,
                     0};
  record.decision.span = {};
  record.decision.solution.clear();
  record.decision.witness.assignment.clear();
  return record;
}

ShownRecord record_of(const ShownResult& shown) {
  ShownRecord record{place_at(shown.span),
                     shown.instance,
                     shown.joint ? as_written(shown.joint->span) : shown.term,
                     shown.value,
                     shown.joint,
                     false};
  if (record.joint) record.joint->span = {};
  return record;
}

AuditRecord record_of(const CaseAudit& audit) {
  const bool flagged = std::any_of(
      audit.assumptions.begin(), audit.assumptions.end(),
      [](const auto& assumption) { return assumption.status == AssumptionAudit::Status::flagged; });
  return {audit_text(audit, false), audit_text(audit, true),
          to_json(audit).dump(-1, ' ', false, Json::error_handler_t::replace), flagged, false};
}

AuditRecord lost_audit(const std::string& case_name, const std::string& why) {
  const std::string text = "assumptions of " + case_name + " were not looked at: " + why + "\n";
  const Json object{{"case", case_name},
                    {"claims", Json::array()},
                    {"assumptions", Json::array()},
                    {"lost", why}};
  return {text, text, object.dump(-1, ' ', false, Json::error_handler_t::replace), false, true};
}

DiagnosticRecord record_of(const Diagnostic& diagnostic) {
  return {place_at(diagnostic.span), diagnostic.message, diagnostic.help, to_text(diagnostic)};
}

CaseRecord record_of(const Case& given) {
  return {given.name, given.title, place_at(given.span), excerpt_of(given.span), {}, {}, {}};
}

FileRecord record_of(const FileReport& file) {
  FileRecord record{file.path, file.unreadable, {}, {}};
  for (const Diagnostic& diagnostic : file.diagnostics)
    record.diagnostics.push_back(record_of(diagnostic));
  for (const CaseResult& result : file.cases) {
    CaseRecord& of = record.cases.emplace_back(record_of(result.verified));
    for (const ClaimResult& claim : result.claims)
      of.claims.push_back(record_of(result.verified, claim));
    for (const ShownResult& shown : result.shown) of.shown.push_back(record_of(shown));
    for (const CaseAudit& audit : file.audits)
      if (audit.name == of.name) of.audit = record_of(audit);
  }
  return record;
}

bool needs_attention(const ClaimRecord& claim, bool strict) {
  const bool conditional = claim.decision.verdict == Verdict::proved_if;
  return claim.outcome != Outcome::as_expected || (strict && conditional);
}

}  // namespace patchproof
