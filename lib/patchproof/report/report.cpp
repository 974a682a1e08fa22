#include <patchproof/report/report.hpp>

#include <algorithm>
#include <array>

#include <patchproof/report/run_record.hpp>

namespace patchproof {

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

ExitCode exit_code(const Report& report) { return exit_code(record_of(report)); }

}  // namespace patchproof
