#pragma once

#include <memory>
#include <string>
#include <vector>

#include <patchproof/report/report.hpp>

namespace patchproof {

/// A text the claims of these tests are written in; nothing is decided here.
inline std::shared_ptr<const SourceText> written_text() {
  static const auto text = std::make_shared<const SourceText>(SourceText{
      "a.proof",
      "case a\n  scalar x, y\n  prove  one: x == y\n  prove  two: x ==\n      y\nend\n"});
  return text;
}

/// The bytes of a part of that text.
inline Span span_of(const std::string& part) {
  const auto text = written_text();
  const std::size_t begin = text->text.find(part);
  return {text, begin, begin + part.size()};
}

/// A claim with its verdict, as the engines might have given it.
inline ClaimResult result_of(const std::string& label, Expectation expectation, Verdict verdict,
                             const std::string& instance = "") {
  ClaimResult result;
  result.claim.label = label;
  result.claim.instance = instance;
  result.claim.verb = to_text(expectation);
  result.claim.expectation = expectation;
  result.claim.span = span_of("prove  one: x == y");
  result.claim.statement = span_of("x == y");
  result.decision.verdict = verdict;
  result.outcome = outcome_of(expectation, verdict);
  return result;
}

/// A report about one case "a" with these claims.
inline Report report_of(std::vector<ClaimResult> claims, bool strict = false) {
  CaseResult result;
  result.verified.name = "a";
  result.claims = std::move(claims);
  Report report;
  report.strict = strict;
  report.files.push_back({"a.proof", "", {}, {std::move(result)}});
  return report;
}

}  // namespace patchproof
