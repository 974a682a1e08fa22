#include "opinion.hpp"

#include <stdexcept>

#include <tests/decide/verdicts.hpp>

namespace patchproof::differential {
namespace {

Decision decision_of(const Case& given, Engines engines) {
  VerificationOptions options;
  options.engines = engines;
  return verified(given, options).claims.at(0).decision;
}

std::string fault_of(const Example& example, const Decision& both, const Decision& kernel) {
  if (both.verdict == Verdict::internal) return "the engines disagree";
  if (both.verdict != kernel.verdict) return "the second engine changes the verdict";
  if (both.verdict == Verdict::unknown) return "";
  const Verdict truth = example.conditional ? Verdict::proved_if : Verdict::proved;
  const Verdict expected = example.holds ? truth : Verdict::refuted;
  if (both.verdict == expected) return "";
  return std::string{example.holds ? "a true claim" : "a near miss"} + " is " +
         to_text(both.verdict);
}

}  // namespace

Judgement judged(const Example& example) {
  if (example.holds != example.meaning_holds)
    return {"", "", "the generator takes a claim for something else than it means"};
  const std::string text = case_of(example);
  const auto source = std::make_shared<const SourceText>(SourceText{"random.proof", text});
  Limits limits;
  limits.steps = 20'000'000;
  limits.time = std::chrono::seconds{60};
  const ReadFile read =
      read_cases(source, limits, [](const std::string&) { return std::optional<std::string>{}; });
  if (!read.diagnostics.empty())
    return {"", to_text(read.diagnostics[0]), "the case cannot be read"};
  const Decision both = decision_of(read.cases.at(0), Engines::both);
  const Decision kernel = decision_of(read.cases.at(0), Engines::kernel);
  std::string evidence = both.verdict == Verdict::proved || both.verdict == Verdict::refuted
                             ? to_text(both.evidence)
                             : both.reason;
  for (const std::string& condition : both.conditions) evidence += " {" + condition + "}";
  return {to_text(both.verdict), evidence, fault_of(example, both, kernel)};
}

}  // namespace patchproof::differential
