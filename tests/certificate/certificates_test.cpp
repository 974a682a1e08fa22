#include <patchproof/certificate/certificates.hpp>

#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

std::variant<Certificate, NotCertified> certificate_of(const std::string& statements) {
  const std::vector<CaseResult> results = results_of("case c\n" + statements + "end\n");
  const ClaimResult& claim = results.front().claims.back();
  return certificate(claim, "c", Limits{});
}

std::string why_not(const std::string& statements) {
  const auto found = certificate_of(statements);
  const auto* missing = std::get_if<NotCertified>(&found);
  return missing == nullptr ? "" : missing->why;
}

const std::vector<SequentProof>& proofs(const std::variant<Certificate, NotCertified>& found) {
  return std::get<std::vector<SequentProof>>(std::get<Certificate>(found).content);
}

const EquationProof& equation(const std::variant<Certificate, NotCertified>& found) {
  return std::get<EquationProof>(proofs(found).front().components.front().why);
}

}  // namespace

TEST_CASE("an identity needs no data") {
  const auto found = certificate_of("  scalar a, b\n  prove p: (a + b)^2 == a^2 + 2*a*b + b^2\n");
  CHECK(equation(found).cofactors.empty());
  CHECK(std::get<Certificate>(found).claim == "c.p");
  CHECK(std::get<Certificate>(found).statement == "(a + b)^2 == a^2 + 2*a*b + b^2");
}

TEST_CASE("an equation for all u is used where its functions are asked for") {
  const auto found = certificate_of(
      "  param u in [0, 1]\n  scalar f(t), g(t)\n  assume sum: f(u) + g(u) == 1\n"
      "  prove p: f(0) + f(1) + g(0) + g(1) == 2\n");
  const std::vector<Cofactor>& cofactors = equation(found).cofactors;
  REQUIRE(cofactors.size() == 2);
  CHECK(cofactors[0].equation.at.front().number() + cofactors[1].equation.at.front().number() == 1);
}

TEST_CASE("an equation without unknown functions is used at as many places as its degree asks for") {
  const auto found = certificate_of(
      "  param u in [0, 1]\n  scalar a, b\n  derive both: a, b from a*u + b*(1 - u) == 1 + u\n"
      "      gives 2, 1\n");
  REQUIRE(proofs(found).size() == 2);
  CHECK(proofs(found)[0].components.size() == 4);
  CHECK(proofs(found)[1].sequent.hypotheses.size() == 2);
}

TEST_CASE("a divisor is accounted for by an assumption, by its sign or by a condition") {
  const auto by_assumption =
      certificate_of("  scalar a, b\n  assume d: a != b\n  prove p: (a^2 - b^2)/(a - b) == a + b\n");
  CHECK(proofs(by_assumption).front().not_zero.front().hypothesis == 0);
  const auto by_sign = certificate_of("  scalar w\n  assume d: w > 0\n  prove p: w/(1 + w) + 1/(1 + w) == 1\n");
  CHECK(proofs(by_sign).front().not_zero.front().sign);
  const auto by_condition = certificate_of("  scalar a\n  prove p: a/a == 1\n");
  CHECK(proofs(by_condition).front().sequent.hypotheses.front().label == "condition");
}

TEST_CASE("a bound that is attained inside is a square times a fact") {
  CHECK(why_not("  param u in [0, 1]\n  prove p: u*(1 - u)^2 <= 4/27\n") == "");
  CHECK(why_not("  param u, v in [0, 1]\n  prove p: u*v*(1 - u)*(1 - v) <= 1/16\n") == "");
}

TEST_CASE("what has no certificate says why") {
  CHECK(why_not("  param u, v in [0, 1]\n  open p: (u - 2/3)^2*(5/2 + v) + (v - 1)^2 > -1/2^61\n") == "there is no verdict to be certified");
  CHECK(why_not("  scalar x\n  derive p: x from x == x + 1 inconsistent\n") ==
        "a derivation without a unique solution");
}

TEST_CASE("a refutation keeps its witness and the component that differs") {
  const auto found = certificate_of("  scalar a, b\n  refute p: (a, b) == (a, 2*b)\n");
  const auto& refutation = std::get<Refutation>(std::get<Certificate>(found).content);
  CHECK(refutation.component == 1);
  CHECK(refutation.values.size() == 2);
}

}  // namespace patchproof
