// Fuzz target of the whole check with a small budget: it ends well, finds the same twice and in the
// formatted text, the engines never disagree, and the exit code says what the verdicts are.

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <patchproof/language/formatter.hpp>
#include <patchproof/patchproof.hpp>
#include <tests/fuzz/law.hpp>
#include <tests/fuzz/token_mutation.hpp>

namespace {

using namespace patchproof;

/// Counted work only: what a clock or the memory ends does not end the same way twice.
CheckOptions small_budget() {
  CheckOptions options;
  options.limits.time = std::chrono::milliseconds{0};
  options.limits.memory = 0;
  options.limits.terms = 2'000;
  options.limits.steps = 50'000;
  return options;
}

Report report_of(const std::string& text) {
  return check({{"fuzz.proof", text, ""}}, small_budget());
}

/// Every claim with its verdict, and every value shown.
std::string verdicts_in(const Report& report) {
  std::string result;
  for (const FileReport& file : report.files)
    for (const CaseResult& of : file.cases) {
      for (const ClaimResult& claim : of.claims)
        result += claim_id(of.verified, claim.claim) + " " + to_text(claim.decision.verdict) + "\n";
      for (const ShownResult& shown : of.shown) result += "show " + shown.value + "\n";
    }
  return result;
}

/// The exit code by the table of the language reference, found anew from the outcomes.
ExitCode expected_code(const FileReport& file) {
  std::vector<Outcome> outcomes;
  for (const CaseResult& of : file.cases)
    for (const ClaimResult& claim : of.claims) outcomes.push_back(claim.outcome);
  const auto some = [&](Outcome outcome) {
    return std::find(outcomes.begin(), outcomes.end(), outcome) != outcomes.end();
  };
  if (some(Outcome::internal)) return ExitCode::internal;
  if (some(Outcome::error) || !file.diagnostics.empty()) return ExitCode::unreadable;
  if (some(Outcome::wrong)) return ExitCode::wrong;
  if (some(Outcome::vacuous)) return ExitCode::conditional;
  if (some(Outcome::unknown)) return ExitCode::unknown;
  return outcomes.empty() ? ExitCode::nothing_ran : ExitCode::as_expected;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const Report report = report_of(text);
  const FileReport& file = report.files.at(0);
  const ExitCode code = exit_code(report);
  if (code == ExitCode::internal) fuzz::violated("no fault of the program", verdicts_in(report));
  if (code != expected_code(file)) fuzz::violated("the exit code says what came out", text);
  const std::string written_once = written(report, "text", {});
  written(report, "json", {});
  if (file.cases.empty()) return 0;
  if (written(report_of(text), "text", {}) != written_once)
    fuzz::violated("deciding twice finds the same", text);
  if (!file.diagnostics.empty()) return 0;
  const std::string once = formatted(SourceText{"fuzz.proof", text});
  if (verdicts_in(report_of(once)) != verdicts_in(report))
    fuzz::violated("a formatted text has the same verdicts", once);
  return 0;
}
