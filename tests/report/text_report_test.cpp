#include <catch2/catch.hpp>

#include <patchproof/report/text_report.hpp>

#include "report_test.hpp"

namespace patchproof {

namespace {

std::string text_of(const Report& report, Verbosity verbosity = Verbosity::normal) {
  return written(record_of(report), "text", {verbosity, false});
}

ClaimResult refuted(const std::string& label) {
  ClaimResult result = result_of(label, Expectation::prove, Verdict::refuted);
  result.decision.residual = "x - y";
  result.decision.witness = {{{"y", "0"}, {"x", "1"}, {"V", "(0, 0)"}}, {}, "1", "0", ""};
  return result;
}

}  // namespace

TEST_CASE("Claims are listed in aligned lines, and counted") {
  const Report report = report_of({result_of("one", Expectation::prove, Verdict::proved),
                                   result_of("three", Expectation::refute, Verdict::refuted)});
  CHECK(text_of(report) ==
        "  a.one    PROVED\n"
        "  a.three  REFUTED\n"
        "\n"
        "2 claims in 1 case: 2 as expected (1 proved, 1 refuted)\n");
}

TEST_CASE("A false claim is shown as written, with what makes it false") {
  CHECK(text_of(report_of({refuted("one")})) ==
        "! a.one  REFUTED  (expected PROVED)\n"
        "\n"
        "a.proof:3:15: a.one: expected PROVED, found REFUTED\n"
        "     3 |   prove  one: x == y\n"
        "       |               ^^^^^^\n"
        "       = left - right: x - y\n"
        "       = witness: x = 1; all others 0\n"
        "       = left side: 1\n"
        "       = right side: 0\n"
        "\n"
        "1 claim in 1 case: 1 wrong\n");
}

TEST_CASE("A statement of several lines is shown whole") {
  ClaimResult result = refuted("two");
  result.claim.statement = span_of("x ==\n      y");
  const std::string text = text_of(report_of({result}), Verbosity::quiet);
  CHECK(
      text.starts_with("a.proof:4:15: a.two: expected PROVED, found REFUTED\n"
                       "     4 |   prove  two: x ==\n"
                       "     5 |       y\n"
                       "       = left - right: x - y\n"));
}

TEST_CASE("A quiet report has no lines for what is as expected") {
  CHECK(text_of(report_of({result_of("one", Expectation::prove, Verdict::proved)}),
                Verbosity::quiet) == "1 claim in 1 case: 1 as expected (1 proved)\n");
}

TEST_CASE("Instances of a family with one answer share a line") {
  std::vector<ClaimResult> claims;
  for (int i = 0; i < 36; ++i)
    claims.push_back(
        result_of("south", Expectation::prove, Verdict::proved, "[i=" + std::to_string(i) + "]"));
  CHECK(text_of(report_of(claims)) ==
        "  a.south  PROVED  (36 instances)\n"
        "\n"
        "36 claims in 1 case: 36 as expected (36 proved)\n");
  claims[7].decision.verdict = Verdict::unknown;
  claims[7].decision.reason = "limit: more than 5 steps";
  claims[7].outcome = Outcome::unknown;
  CHECK(text_of(report_of(claims)) ==
        "  a.south       PROVED  (35 instances)\n"
        "! a.south[i=7]  UNKNOWN: limit: more than 5 steps\n"
        "\n"
        "a.proof:3:15: a.south[i=7]: expected PROVED, found UNKNOWN\n"
        "     3 |   prove  one: x == y\n"
        "       |               ^^^^^^\n"
        "       = reason: limit: more than 5 steps\n"
        "       = help: allow more with --limit-time, --limit-memory, --limit-terms or "
        "--limit-steps, "
        "or with 'limit' in the case\n"
        "\n"
        "36 claims in 1 case: 35 as expected (35 proved), 1 unknown\n");
  claims[9].decision = claims[7].decision;
  claims[9].outcome = Outcome::unknown;
  CHECK(text_of(report_of(claims))
            .starts_with("  a.south       PROVED  (34 instances)\n"
                         "! a.south[i=7]  UNKNOWN: limit: more than 5 steps\n"
                         "! a.south[i=9]  UNKNOWN: limit: more than 5 steps\n"));
}

TEST_CASE("Conditions are told, and in a strict report also how to state them") {
  ClaimResult result = result_of("one", Expectation::prove, Verdict::proved_if);
  result.decision.conditions = {"a - b != 0", "c != 0"};
  CHECK(text_of(report_of({result})) ==
        "  a.one  PROVED IF a - b != 0 and c != 0\n"
        "\n"
        "1 claim in 1 case: 1 as expected (1 proved if)\n");
  const std::string strict = text_of(report_of({result}, true));
  CHECK(strict.find("! a.one  PROVED IF a - b != 0 and c != 0\n") == 0);
  CHECK(strict.find("       = help: where the condition is meant, say so in the case: "
                    "assume a - b != 0\n") != std::string::npos);
}

TEST_CASE("A stale expectation is shown with what to write instead") {
  const std::string text =
      text_of(report_of({result_of("one", Expectation::refute, Verdict::proved)}));
  CHECK(text.find("a.one: expected REFUTED, found PROVED\n") != std::string::npos);
  CHECK(text.find("       = help: the statement is true: write 'prove one: ...' in place of "
                  "'refute'\n") != std::string::npos);
}

TEST_CASE("Unknowns that stay arbitrary are named") {
  ClaimResult result = result_of("one", Expectation::prove, Verdict::underdetermined);
  result.decision.free = {"V[1,1]", "V[1,2]"};
  result.decision.derived = {{"V[2,2]", "V[1,1] + 1"}};
  const std::string text = text_of(report_of({result}));
  CHECK(text.find("! a.one  UNDERDETERMINED: free V[1,1], V[1,2]  (expected PROVED)\n") == 0);
  CHECK(text.find("       = free: V[1,1], V[1,2]\n"
                  "       = derived: V[2,2] = V[1,1] + 1\n") != std::string::npos);
}

TEST_CASE("A statement without a value is shown where it has none") {
  ClaimResult result = result_of("one", Expectation::prove, Verdict::error);
  result.decision.reason = "division by zero";
  result.decision.span = span_of("y");
  const std::string text = text_of(report_of({result}));
  CHECK(text.find("a.proof:2:13: error: division by zero\n"
                  "     2 |   scalar x, y\n"
                  "       |             ^\n") != std::string::npos);
}

TEST_CASE("Colours say nothing the text does not say") {
  const Report report = report_of({refuted("one")});
  std::string coloured = written(record_of(report), "text", {Verbosity::normal, true});
  for (std::size_t at; (at = coloured.find('\x1b')) != std::string::npos;)
    coloured.erase(at, coloured.find('m', at) - at + 1);
  CHECK(coloured == text_of(report));
}

TEST_CASE("Titles cannot bring control characters into a report") {
  Report report = report_of({result_of("one", Expectation::prove, Verdict::proved)});
  report.files[0].cases[0].verified.title = "red \x1b[31m";
  CHECK(text_of(report, Verbosity::verbose).find('\x1b') == std::string::npos);
}

TEST_CASE("A path that cannot be read is named with the reason", "[reject]") {
  Report report;
  report.files.push_back({"x.proof", "No such file or directory", {}, {}});
  CHECK(mistakes(report) == "patchproof: cannot read 'x.proof': No such file or directory\n");
  CHECK(text_of(report) == "0 claims in 0 cases: nothing was decided, 1 path not read\n");
}

}  // namespace patchproof
