#include <patchproof/report/report.hpp>

#include <algorithm>
#include <array>

namespace patchproof {

namespace {

ExitCode code_of(const ClaimResult& result, bool strict) {
  switch (result.outcome) {
    case Outcome::as_expected:
      return needs_attention(result, strict) ? ExitCode::conditional : ExitCode::as_expected;
    case Outcome::wrong:
      return ExitCode::wrong;
    case Outcome::unknown:
      return ExitCode::unknown;
    case Outcome::vacuous:
      return ExitCode::conditional;
    case Outcome::error:
      return ExitCode::unreadable;
    default:
      return ExitCode::internal;
  }
}

bool has_flagged(const FileReport& file) {
  for (const CaseAudit& audit : file.audits)
    for (const AssumptionAudit& assumption : audit.assumptions)
      if (assumption.status == AssumptionAudit::Status::flagged) return true;
  return false;
}

}  // namespace

std::string claim_id(const Case& of, const Claim& claim) {
  return of.name + "." + claim.label + claim.instance;
}

bool needs_attention(const ClaimResult& result, bool strict) {
  const bool conditional = result.decision.verdict == Verdict::proved_if;
  return result.outcome != Outcome::as_expected || (strict && conditional);
}

ExitCode graver(ExitCode a, ExitCode b) {
  constexpr std::array by_gravity{
      ExitCode::internal,    ExitCode::usage,   ExitCode::unreadable,  ExitCode::wrong,
      ExitCode::conditional, ExitCode::unknown, ExitCode::nothing_ran, ExitCode::as_expected};
  return *std::find_if(by_gravity.begin(), by_gravity.end(),
                       [&](ExitCode code) { return code == a || code == b; });
}

ExitCode exit_code(const Report& report) {
  ExitCode worst = ExitCode::as_expected;
  bool ran = false;
  for (const FileReport& file : report.files) {
    if (!file.unreadable.empty() || !file.diagnostics.empty())
      worst = graver(worst, ExitCode::unreadable);
    for (const CaseResult& result : file.cases) {
      for (const ClaimResult& claim : result.claims) {
        ran = true;
        worst = graver(worst, code_of(claim, report.strict));
      }
    }
    if (has_flagged(file)) worst = graver(worst, ExitCode::wrong);
  }
  return ran ? worst : graver(worst, ExitCode::nothing_ran);
}

}  // namespace patchproof
