#include <catch2/catch.hpp>

#include "report_test.hpp"

namespace patchproof {

namespace {

int code(std::vector<ClaimResult> claims, bool strict = false) {
  return static_cast<int>(exit_code(report_of(std::move(claims), strict)));
}

const ClaimResult proved = result_of("p", Expectation::prove, Verdict::proved);
const ClaimResult conditional = result_of("c", Expectation::prove, Verdict::proved_if);
const ClaimResult false_prove = result_of("f", Expectation::prove, Verdict::refuted);
const ClaimResult unknown = result_of("u", Expectation::prove, Verdict::unknown);
const ClaimResult vacuous = result_of("v", Expectation::prove, Verdict::vacuous);
const ClaimResult error = result_of("e", Expectation::prove, Verdict::error);
const ClaimResult internal = result_of("i", Expectation::prove, Verdict::internal);

}  // namespace

TEST_CASE("A run in which nothing was decided is no success") {
  CHECK(exit_code(Report{}) == ExitCode::nothing_ran);
  CHECK(code({}) == 5);
}

TEST_CASE("A run is a success when every claim is decided as expected") {
  CHECK(code({proved}) == 0);
  CHECK(code({proved, result_of("r", Expectation::refute, Verdict::refuted)}) == 0);
  CHECK(code({result_of("o", Expectation::open, Verdict::unknown)}) == 0);
  CHECK(code({result_of("n", Expectation::inconsistent, Verdict::inconsistent)}) == 0);
}

TEST_CASE("A stale expectation is wrong") {
  CHECK(code({result_of("r", Expectation::refute, Verdict::proved)}) == 1);
  CHECK(code({result_of("o", Expectation::open, Verdict::proved)}) == 1);
  CHECK(code({result_of("o", Expectation::open, Verdict::refuted)}) == 1);
  CHECK(code({result_of("d", Expectation::prove, Verdict::underdetermined)}) == 1);
}

TEST_CASE("A conditional proof is a failure only in a strict report") {
  CHECK(code({conditional}) == 0);
  CHECK(code({conditional}, true) == 3);
  CHECK(code({proved}, true) == 0);
}

TEST_CASE("The gravest of what happened is the exit code") {
  CHECK(code({unknown}) == 2);
  CHECK(code({unknown, vacuous}) == 3);
  CHECK(code({unknown, vacuous, false_prove}) == 1);
  CHECK(code({unknown, vacuous, false_prove, error}) == 4);
  CHECK(code({internal, unknown, vacuous, false_prove, error}) == 70);
  CHECK(graver(ExitCode::usage, ExitCode::internal) == ExitCode::internal);
  CHECK(graver(ExitCode::usage, ExitCode::unreadable) == ExitCode::usage);
  CHECK(graver(ExitCode::nothing_ran, ExitCode::as_expected) == ExitCode::nothing_ran);
}

TEST_CASE("A mistake in a text outweighs what was decided beside it") {
  Report report = report_of({proved, false_prove});
  report.files.push_back({"b.proof", "", {{span_of("scalar"), "no", ""}}, {}});
  CHECK(exit_code(report) == ExitCode::unreadable);
  report.files.back() = {"b.proof", "No such file or directory", {}, {}};
  CHECK(exit_code(report) == ExitCode::unreadable);
}

}  // namespace patchproof
