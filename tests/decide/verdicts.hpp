#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include <patchproof/claims/verification.hpp>
#include <patchproof/language/reader.hpp>

/// Decides small cases written in the case language, and says in one line per claim what came out.
namespace patchproof {

/// All results of the cases of a text.
/// @throws std::invalid_argument with the messages when the text is faulty.
inline std::vector<CaseResult> results_of(const std::string& text, const Limits& limits = {}) {
  const auto source = std::make_shared<const SourceText>(SourceText{"test.proof", text});
  const ReadFile read =
      read_cases(source, limits, [](const std::string&) { return std::optional<std::string>{}; });
  if (!read.diagnostics.empty()) {
    std::string messages;
    for (const Diagnostic& diagnostic : read.diagnostics) messages += to_text(diagnostic);
    throw std::invalid_argument{messages};
  }
  std::vector<CaseResult> results;
  for (const Case& given : read.cases) results.push_back(verified(given, {}));
  return results;
}

/// "label VERDICT {condition} {condition} uses assumption free unknown (reason)".
///
/// The reason only for UNKNOWN, ERROR, INTERNAL and INCONSISTENT.
inline std::string line_of(const ClaimResult& result) {
  const Decision& decision = result.decision;
  std::string line = result.claim.label + result.claim.instance + " " + to_text(decision.verdict);
  for (const std::string& condition : decision.conditions) line += " {" + condition + "}";
  for (const std::string& label : decision.assumptions_used) line += " uses " + label;
  for (const std::string& name : decision.free) line += " free " + name;
  const bool with_reason =
      decision.verdict == Verdict::unknown || decision.verdict == Verdict::error ||
      decision.verdict == Verdict::internal || decision.verdict == Verdict::inconsistent;
  if (with_reason) line += " (" + decision.reason + ")";
  return line + "\n";
}

/// One line for each claim of all cases of a whole text.
inline std::string verdicts_of(const std::string& text, const Limits& limits = {}) {
  std::string lines;
  for (const CaseResult& result : results_of(text, limits))
    for (const ClaimResult& claim : result.claims) lines += line_of(claim);
  return lines;
}

/// The lines of all claims of the statements of one case.
inline std::string verdicts(const std::string& statements, const Limits& limits = {}) {
  std::string lines;
  for (const CaseResult& result : results_of("case t\n" + statements + "end\n", limits))
    for (const ClaimResult& claim : result.claims) lines += line_of(claim);
  return lines;
}

/// The verdict of a proposition under the declarations before it, without anything else: "PROVED".
inline std::string verdict(const std::string& declarations, const std::string& proposition) {
  const auto results =
      results_of("case t\n" + declarations + "\nprove p: " + proposition + "\nend\n");
  return to_text(results.at(0).claims.at(0).decision.verdict);
}

}  // namespace patchproof
