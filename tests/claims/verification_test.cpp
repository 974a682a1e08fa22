#include <patchproof/claims/verification.hpp>

#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

TEST_CASE("outcomes are what the author expects of the verdict, or not") {
  using E = Expectation;
  using V = Verdict;
  using O = Outcome;
  CHECK(outcome_of(E::prove, V::proved) == O::as_expected);
  CHECK(outcome_of(E::prove, V::proved_if) == O::as_expected);
  CHECK(outcome_of(E::prove, V::refuted) == O::wrong);
  CHECK(outcome_of(E::prove, V::underdetermined) == O::wrong);
  CHECK(outcome_of(E::prove, V::inconsistent) == O::wrong);
  CHECK(outcome_of(E::prove, V::unknown) == O::unknown);
  CHECK(outcome_of(E::refute, V::refuted) == O::as_expected);
  CHECK(outcome_of(E::refute, V::proved) == O::wrong);
  CHECK(outcome_of(E::refute, V::proved_if) == O::wrong);
  CHECK(outcome_of(E::refute, V::unknown) == O::unknown);
  CHECK(outcome_of(E::open, V::unknown) == O::as_expected);
  CHECK(outcome_of(E::open, V::proved) == O::wrong);
  CHECK(outcome_of(E::open, V::refuted) == O::wrong);
  CHECK(outcome_of(E::inconsistent, V::inconsistent) == O::as_expected);
  CHECK(outcome_of(E::inconsistent, V::proved) == O::wrong);
  CHECK(outcome_of(E::inconsistent, V::unknown) == O::unknown);
  for (const E expectation : {E::prove, E::refute, E::open, E::inconsistent}) {
    CHECK(outcome_of(expectation, V::internal) == O::internal);
    CHECK(outcome_of(expectation, V::error) == O::error);
    CHECK(outcome_of(expectation, V::vacuous) == O::vacuous);
  }
}

TEST_CASE("expectations, verdicts and evidence have their words") {
  CHECK(to_text(Expectation::prove) == "prove");
  CHECK(to_text(Expectation::refute) == "refute");
  CHECK(to_text(Expectation::open) == "open");
  CHECK(to_text(Expectation::inconsistent) == "inconsistent");
  CHECK(to_text(Verdict::proved) == "PROVED");
  CHECK(to_text(Verdict::proved_if) == "PROVED IF");
  CHECK(to_text(Verdict::refuted) == "REFUTED");
  CHECK(to_text(Verdict::vacuous) == "VACUOUS");
  CHECK(to_text(Verdict::underdetermined) == "UNDERDETERMINED");
  CHECK(to_text(Verdict::inconsistent) == "INCONSISTENT");
  CHECK(to_text(Verdict::unknown) == "UNKNOWN");
  CHECK(to_text(Verdict::error) == "ERROR");
  CHECK(to_text(Verdict::internal) == "INTERNAL");
  CHECK(to_text(Evidence::none) == "none");
  CHECK(to_text(Evidence::kernel) == "kernel");
  CHECK(to_text(Evidence::both_engines) == "both engines");
}

TEST_CASE("claims keep the order in which they are written, families their instances") {
  CHECK(verdicts(R"~(
  point b[0..2]
  prove corner: b[i] == b[i] for i in 0..2
  prove entry: bernstein(2, i, j) == bernstein(2, 2 - i, 1 - j) for i in 0..1, j in 0..1
  refute same: b[i] == b[0] for i in 1..2
)~") == R"~(corner[i=0] PROVED
corner[i=1] PROVED
corner[i=2] PROVED
entry[i=0,j=0] PROVED
entry[i=0,j=1] PROVED
entry[i=1,j=0] PROVED
entry[i=1,j=1] PROVED
same[i=1] REFUTED
same[i=2] REFUTED
)~");
}

TEST_CASE("a whole case can be a family, and each member uses its own derivations") {
  CHECK(verdicts(R"~(
  family m in 1..3
  param t in [0, 1]
  point b[0..m]
  scalar x
  curve C(t) = bezier(b)
  derive degree: x from x == m gives m
  prove slope: diff(C, t)(0) == x*(b[1] - b[0]) using degree
  refute last: C(1) == b[m-1]
)~") == R"~(degree[m=1] PROVED
slope[m=1] PROVED
last[m=1] REFUTED
degree[m=2] PROVED
slope[m=2] PROVED
last[m=2] REFUTED
degree[m=3] PROVED
slope[m=3] PROVED
last[m=3] REFUTED
)~");
}

TEST_CASE("an erratum is two claims: the printed one and the corrected one") {
  const auto results = results_of(R"~(
case t
  scalar x
  erratum sign
    printed   (x - 1)^2 == x^2 - 2*x - 1
    corrected (x - 1)^2 == x^2 - 2*x + 1
    note "a sign"
  end
  erratum not_one
    printed   x + x == 2*x
    corrected x + x == 3*x
  end
end
)~");
  REQUIRE(results.size() == 1);
  const auto& claims = results[0].claims;
  REQUIRE(claims.size() == 4);
  CHECK(line_of(claims[0]) == "sign.printed REFUTED\n");
  CHECK(line_of(claims[1]) == "sign.corrected PROVED\n");
  CHECK(claims[0].claim.note == "a sign");
  CHECK(claims[0].outcome == Outcome::as_expected);
  CHECK(claims[1].outcome == Outcome::as_expected);
  CHECK(line_of(claims[2]) == "not_one.printed PROVED\n");
  CHECK(claims[2].outcome == Outcome::wrong);
  CHECK(claims[3].outcome == Outcome::wrong);
}

TEST_CASE("claims that are not wanted are left out, but derivations they need are made") {
  const auto source = std::make_shared<const SourceText>(SourceText{"test.proof", R"~(
case t
  scalar x, y
  derive two: x from x == 2 gives 2
  derive three: y from y == x + 1 using two gives 3
  prove sum: x + y == 5 using two, three
  prove other: x == x
end
)~"});
  const ReadFile read =
      read_cases(source, Limits{}, [](const std::string&) { return std::optional<std::string>{}; });
  REQUIRE(read.diagnostics.empty());
  std::vector<std::string> seen;
  VerificationOptions options;
  options.engines = Engines::kernel;
  options.wanted = [](const Claim& claim) { return claim.label == "sum"; };
  options.progress = [&](const Claim& claim) { seen.push_back(claim.label); };
  const CaseResult result = verified(read.cases.at(0), options);
  REQUIRE(result.claims.size() == 1);
  CHECK(line_of(result.claims[0]) == "sum PROVED\n");
  CHECK(result.claims[0].decision.evidence == Evidence::kernel);
  CHECK(seen == std::vector<std::string>{"sum"});
}

TEST_CASE("show gives the term as written and its normal form") {
  const auto results = results_of(R"~(
case t
  param u in [0, 1]
  scalar x
  point A, B
  show (x + 1)^2 - 1
  show (1-u)*A + u*B
  show x/x
  show 1/(x - x)
  show [x, 1 ; 2, x + x]
  show (u + u, 1/2)
end
)~");
  std::string lines;
  for (const ShownResult& shown : results.at(0).shown)
    lines += shown.term + " = " + shown.value + "\n";
  CHECK(lines == R"~((x + 1)^2 - 1 = x^2 + 2*x
(1 - u)*A + u*B = (1-u)*A + u*B
x/x = 1
1/(x - x) = no value: division by zero
[x, 1 ; 2, x + x] = [x, 1 ; 2, 2*x]
(u + u, 1/2) = (2*u, 1/2)
)~");
}

TEST_CASE("both engines confirm what they both can decide") {
  const auto results = results_of(R"~(
case t
  scalar x, y
  prove equation: (x + y)^2 == x^2 + 2*x*y + y^2
  refute false_equation: (x + y)^2 == x^2 + y^2
  prove inequality: x^2 + 1 > 0
  derive solution: x from x + 1 == y gives y - 1
end
)~");
  const auto& claims = results.at(0).claims;
  CHECK(claims[0].decision.evidence == Evidence::both_engines);
  CHECK(claims[1].decision.evidence == Evidence::both_engines);
  CHECK(claims[2].decision.evidence == Evidence::kernel);
  CHECK(claims[3].decision.evidence == Evidence::both_engines);
}

}  // namespace patchproof
