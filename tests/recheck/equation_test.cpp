#include <catch2/catch.hpp>
#include <tests/recheck/hand_made.hpp>

using namespace patchproof;
using namespace patchproof::test;

namespace {

const std::string proof = "/certificates/0/proofs/0";

const Claims& blends() {
  static const Claims claims{R"(
    param u in [0, 1]
    scalar a
    scalar f1(t) : C^1
    scalar f2(t) : C^1
    assume sum: f1(u) + f2(u) == 1
    prove at_half: 3*f1(1/2) + 3*f2(1/2) == 3
    prove slope: f1'(0) + f2'(0) == 0
    prove itself: a*f1(u) + a*f2(u) == a
    prove mirrored: f1(1-u) + f2(1-u) == 1
    prove beyond: f1(2) + f2(2) == 1
    prove anywhere: f1(a) + f2(a) == 1
    prove three: 3 == 0
    prove one: 1 == 0
    prove half: 1/2 == 0
    prove zero: 0 == 1
    prove two: 2 == 0
    prove letter: a == 0
    prove parameter: u == 0
    prove mirror: 1-u == 0)"};
  return claims;
}

Cofactor multiple(const std::string& at, const std::string& factor, int order = 0) {
  return {{0, 0, {blends().term(at)}, {order}}, blends().term(factor)};
}

std::string shown(const std::string& label, const Cofactor& cofactor) {
  return judged(document_of(by_equations(blends().sequent(label), {cofactor})));
}

}  // namespace

TEST_CASE("An equation at a number, at its parameter, mirrored, differentiated", "[law]") {
  CHECK(shown("at_half", multiple("half", "three")) == "RECHECKED");
  CHECK(shown("itself", multiple("parameter", "letter")) == "RECHECKED");
  CHECK(shown("mirrored", multiple("mirror", "one")) == "RECHECKED");
  CHECK(shown("slope", multiple("zero", "one", 1)) == "RECHECKED");
}

TEST_CASE("A wrong factor, value or order of a hypothesis is rejected", "[reject]") {
  CHECK(shown("at_half", multiple("half", "two")) ==
        "REJECTED proofs[0].components[0]: left - right is not the sum: f1(1/2) + f2(1/2) - 1 is "
        "left");
  CHECK(shown("at_half", multiple("one", "three"))
            .starts_with("REJECTED proofs[0].components[0]: left - right is not the sum: "));
  CHECK(shown("slope", multiple("zero", "one", 2)) ==
        "REJECTED proofs[0].components[0].equation[0]: a derivative of order 2 of 'f1', which is "
        "only assumed C^1");
  CHECK(shown("slope", multiple("zero", "one")).starts_with("REJECTED"));
}

TEST_CASE("An equation is not used outside of the range of its parameter", "[reject]") {
  CHECK(shown("beyond", multiple("two", "one")) ==
        "REJECTED proofs[0].components[0].equation[0]: 2 is not in the range of 'u'");
  CHECK(shown("anywhere", multiple("letter", "one")) ==
        "UNKNOWN proofs[0].components[0].equation[0]: whether a is in the range of 'u'");
}

TEST_CASE("A changed statement is rejected", "[reject]") {
  const std::string good =
      document_of(by_equations(blends().sequent("at_half"), {multiple("half", "three")}));
  REQUIRE(judged(good) == "RECHECKED");
  CHECK(judged(changed(good, proof + "/sequent/hypotheses", nlohmann::json::array())) ==
        "REJECTED proofs[0].components[0].equation[0]: there is no hypothesis 0");
  CHECK(judged(changed(good, proof + "/sequent/hypotheses/0/relation", "<=")) ==
        "REJECTED proofs[0].components[0].equation[0]: hypothesis 0 is no equation");
  CHECK(judged(changed(good, proof + "/sequent/conclusions/0/relation", "!=")) ==
        "REJECTED proofs[0].components[0]: an equation is shown by cofactors, anything else by a "
        "sign");
}

TEST_CASE("What is missing in a proof of equations is missed", "[reject]") {
  const std::string good =
      document_of(by_equations(blends().sequent("at_half"), {multiple("half", "three")}));
  const auto none = nlohmann::json::array();
  CHECK(judged(changed(good, proof + "/components", none)) ==
        "REJECTED proofs[0].sequent.conclusions[0]: component 0 is not shown");
  CHECK(judged(changed(good, proof + "/components/0/equation", none)) ==
        "REJECTED proofs[0].components[0]: left - right is not the sum: 3*f1(1/2) + 3*f2(1/2) - 3 "
        "is left");
  CHECK(judged(changed(good, proof + "/components/0/equation/0/at", none)) ==
        "REJECTED proofs[0].components[0].equation[0]: the parameter 'u' has no value");
  CHECK(judged(changed(good, proof + "/components/0/component", 1)) ==
        "REJECTED proofs[0].components[0]: conclusion 0 has no component 1");
  CHECK(judged(changed(good, proof + "/components/0/conclusion", 1)) ==
        "REJECTED proofs[0].components[0]: there is no conclusion 1");
  CHECK(judged(changed(good, proof + "/components/0/equation/0/component", 1)) ==
        "REJECTED proofs[0].components[0].equation[0]: hypothesis 0 has no component 1");
}

TEST_CASE("Of points and matrices every component has to be shown", "[reject]") {
  const Claims points{R"(
    scalar a
    point P in R^2
    point Q in R^2
    prove twice: a*(P + Q) == a*P + a*Q)"};
  SequentProof proof = by_equations(points.sequent("twice"), {});
  CHECK(judged(document_of(proof)) ==
        "REJECTED proofs[0].sequent.conclusions[0]: component 1 is not shown");
  proof.components.push_back({0, 1, EquationProof{}, false});
  CHECK(judged(document_of(proof)) == "RECHECKED");
}

TEST_CASE("Where a hypothesis restricts a parameter, an equation is used at the parameter alone",
          "[reject]") {
  const Claims claims{R"(
    param u in [0, 1]
    scalar f(t) : C^1
    assume zero: f(u) == 0
    assume late: u >= 1/2
    prove here: f(u) == 0
    prove there: f(0) == 0
    prove slope: f'(u) == 0
    prove u_term: u == 0
    prove zero_term: 0 == 1
    prove one_term: 1 == 0)"};
  const auto at = [&](const std::string& label, const std::string& value, int order) {
    return judged(document_of(
        by_equations(claims.sequent(label),
                     {{{0, 0, {claims.term(value)}, {order}}, claims.term("one_term")}})));
  };
  CHECK(at("here", "u_term", 0) == "RECHECKED");
  CHECK(at("there", "zero_term", 0) ==
        "REJECTED proofs[0].components[0].equation[0]: a hypothesis restricts 'u', so it has to "
        "stay as it is, and not be 0");
  CHECK(at("slope", "u_term", 1) ==
        "REJECTED proofs[0].components[0].equation[0]: an equation differentiated in 'u', which a "
        "hypothesis restricts");
}

TEST_CASE("No derivative of an equation on a range of one point", "[reject]") {
  const std::string good =
      document_of(by_equations(blends().sequent("slope"), {multiple("zero", "one", 1)}));
  const auto lower = nlohmann::json::parse(good).at(
      nlohmann::json::json_pointer{proof + "/sequent/ranges/0/lower"});
  CHECK(
      judged(changed(good, proof + "/sequent/ranges/0/upper", lower)) ==
      "REJECTED proofs[0].components[0].equation[0]: a derivative in 'u', whose range is a point");
}
