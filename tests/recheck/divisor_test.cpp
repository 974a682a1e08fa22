#include <catch2/catch.hpp>
#include <tests/recheck/hand_made.hpp>

using namespace patchproof;
using namespace patchproof::test;

namespace {

const std::string proof = "/certificates/0/proofs/0";

const Claims& quotients() {
  static const Claims claims{R"(
    param u in [0, 1]
    scalar a, b, c
    assume differ: a != b
    assume positive: c > 0
    prove cancelled: (a^2 - b^2)/(a - b) == a + b
    prove squared: 1/(a-b)^2 + 1/c == (c + (a-b)^2)/(c*(a-b)^2)
    prove rational: 1/(1 + c*u) == 1/(1 + c*u)
    prove root: 1/(1 - sqrt(2)) == -1 - sqrt(2)
    prove difference: a - b == 0
    prove c_term: c == 0
    prove weight: 1 + c*u == 0
    prove product: c*(a-b) == 0
    prove large: c*(a-b)*(a+b)^2 == 0
    prove sum: a + b == 0
    prove part: 1/((a-b)*(a+b)) == 1/((a-b)*(a+b))
    prove part_term: (a+b)*(1 + c*u) == 0)"};
  return claims;
}

SequentProof identity(const std::string& label) {
  return by_equations(quotients().sequent(label), {});
}

NonZero by_hypothesis(const std::string& scalar, std::size_t hypothesis) {
  return {quotients().term(scalar), hypothesis, std::nullopt, false};
}

// By a product of the facts u, 1-u, c: numbers 0, 1, 2.
NonZero by_sign(const std::string& scalar, std::vector<Summand> summands) {
  return {quotients().term(scalar), std::nullopt,
          SignProof{{}, Combination{std::move(summands), {}}}, false};
}

}  // namespace

TEST_CASE("Divisors are shown by hypotheses and by signs", "[law]") {
  SequentProof proof = identity("cancelled");
  proof.not_zero = {by_hypothesis("difference", 0)};
  CHECK(judged(document_of(proof)) == "RECHECKED");
  proof = identity("squared");
  proof.not_zero = {by_hypothesis("difference", 0), by_sign("c_term", {{1, {}, {{2, 1}}}})};
  CHECK(judged(document_of(proof)) == "RECHECKED");
  proof = identity("rational");
  proof.not_zero = {by_sign("weight", {{1, {}, {}}, {1, {}, {{0, 1}, {2, 1}}}})};
  CHECK(judged(document_of(proof)) == "RECHECKED");
}

TEST_CASE("Numbers with roots need no proof that they are not zero", "[law]") {
  CHECK(judged(document_of(identity("root"))) == "RECHECKED");
}

TEST_CASE("A divisor that is not shown not to be zero is found", "[reject]") {
  CHECK(judged(document_of(identity("cancelled"))) ==
        "REJECTED proofs[0].sequent: the divisor a - b is not shown not to be zero");
  SequentProof proof = identity("squared");
  proof.not_zero = {by_hypothesis("difference", 0)};
  CHECK(judged(document_of(proof)) ==
        "REJECTED proofs[0].sequent: the divisor c is not shown not to be zero");
  proof = identity("rational");
  proof.not_zero = {by_sign("weight", {{1, {}, {{0, 1}, {2, 1}}}})};
  CHECK(judged(document_of(proof)) ==
        "REJECTED proofs[0].not_zero[0].end: u*c + 1 is not the sum: 1 is left");
}

TEST_CASE("A hypothesis shows only its own difference, and only when it says so", "[reject]") {
  SequentProof proof = identity("cancelled");
  proof.not_zero = {by_hypothesis("sum", 0)};
  CHECK(judged(document_of(proof)) ==
        "REJECTED proofs[0].not_zero[0]: a + b is not the difference in hypothesis 0");
  proof.not_zero = {by_hypothesis("c_term", 1)};
  CHECK(judged(document_of(proof)) ==
        "REJECTED proofs[0].not_zero[0]: hypothesis 1 does not say that scalars differ");
  proof.not_zero = {by_hypothesis("c_term", 2)};
  CHECK(judged(document_of(proof)) == "REJECTED proofs[0].not_zero[0]: there is no hypothesis 2");
}

TEST_CASE("No scalar is shown not to be zero by dividing by it", "[reject]") {
  const Claims claims{R"(
    scalar x
    assume one: 1/x == 1
    prove fine: 1/x == 1
    prove x_term: x == 0
    prove minus: -x == 0)"};
  // x = 1 - x*(1/x - 1) is true wherever 1/x is: but that is what has to be shown.
  SequentProof proof = by_equations(claims.sequent("fine"), {});
  const Cofactor cofactor{{0, 0, {}, {}}, claims.term("minus")};
  proof.not_zero = {{claims.term("x_term"), std::nullopt,
                     SignProof{{}, Combination{{{1, {}, {}}}, {cofactor}}}, false}};
  CHECK(judged(document_of(proof)) ==
        "REJECTED proofs[0].not_zero[0].end.cofactors[0]: the divisor x is not shown not to be "
        "zero");
}

TEST_CASE("A division by zero is found", "[reject]") {
  const Claims claims{R"(
    scalar a, f(t) = 1/t
    prove pole: a*f(a-a) == 0)"};
  CHECK(judged(document_of(by_equations(claims.sequent("pole"), {}))) ==
        "REJECTED proofs[0].sequent: division by zero");
  // The value 0/t is 0, but not at 0.
  const Claims zero{R"(
    scalar a, f(t) = (t - t)/t
    prove gone: f(a - a) == 0)"};
  CHECK(judged(document_of(by_equations(zero.sequent("gone"), {}))) ==
        "REJECTED proofs[0].sequent: division by zero");
}

TEST_CASE("A hint shows a divisor that is a part of a product", "[law]") {
  SequentProof proof = identity("cancelled");
  // (c*(a-b)) is not zero for neither factor is: shown in two pieces, used as one.
  proof.not_zero = {by_hypothesis("difference", 0), by_sign("c_term", {{1, {}, {{2, 1}}}})};
  proof.divisors = {{quotients().term("c_term"), {0, 1}}};
  const std::string good = document_of(proof);
  CHECK(judged(good) == "RECHECKED");
  CHECK(judged(changed(good, "/certificates/0/proofs/0/divisors/0/product", {0, 7})) ==
        "REJECTED proofs[0].divisors[0]: there is no scalar 7 in not_zero");
  proof.divisors = {{quotients().term("sum"), {0, 1}}};
  CHECK(judged(document_of(proof)) ==
        "REJECTED proofs[0].divisors[0]: a + b does not divide the product of the scalars");
  proof.divisors = {{number_term(0), {0, 1}}};
  CHECK(judged(document_of(proof)) == "REJECTED proofs[0].divisors[0]: the factor is zero");
}

TEST_CASE("A divisor may be a part of what is not zero, or of several such scalars", "[law]") {
  const Claims claims{R"(
    scalar a, b, c, d
    assume first: a*b > 0
    assume second: c*d > 0
    prove part: 1/a == 1/a
    prove parts: 1/(a*c) == 1/(a*c)
    prove other: 1/(a + c) == 1/(a + c)
    prove ab: a*b == 0
    prove cd: c*d == 0)"};
  const auto shown = [&](const std::string& label) {
    SequentProof proof = by_equations(claims.sequent(label), {});
    const auto fact = [&](const std::string& scalar, std::size_t index) {
      return NonZero{claims.term(scalar), std::nullopt,
                     SignProof{{}, Combination{{{1, {}, {{index, 1}}}}, {}}}, false};
    };
    proof.not_zero = {fact("ab", 0), fact("cd", 1)};
    return judged(document_of(proof));
  };
  CHECK(shown("part") == "RECHECKED");
  CHECK(shown("parts") == "RECHECKED");
  CHECK(shown("other") ==
        "REJECTED proofs[0].sequent: the divisor a + c is not shown not to be zero");
}

TEST_CASE("The ends of a range divide by nothing that may be zero", "[reject]") {
  const Claims claims{R"(
    scalar a
    param u in [0, 1]
    prove same: u + a == a + u
    prove end: 1/a == 0)"};
  for (const bool upper : {false, true}) {
    Sequent sequent = claims.sequent("same");
    (upper ? sequent.ranges.at(0).upper : sequent.ranges.at(0).lower) = claims.term("end");
    CHECK(judged(document_of(by_equations(sequent, {}))) ==
          "REJECTED proofs[0].sequent: the divisor a is not shown not to be zero");
  }
}

TEST_CASE("A hypothesis and the values in it divide by nothing that may be zero", "[reject]") {
  const Claims claims{R"(
    param u in [0, 1]
    scalar a, x
    scalar f(t)
    assume differ: (a*x)/a != 0
    assume rule: f(u) == f(u)
    prove fine: 1/x == 1/x
    prove plain: a == a
    prove x_term: x == 0
    prove pole: 1/a == 0
    prove one: 1 == 0)"};
  SequentProof proof = by_equations(claims.sequent("fine"), {});
  proof.not_zero = {{claims.term("x_term"), 0, std::nullopt, false}};
  CHECK(judged(document_of(proof)) ==
        "REJECTED proofs[0].not_zero[0]: the divisor a is not shown not to be zero");
  Sequent free = claims.sequent("plain");
  free.hypotheses.erase(free.hypotheses.begin());
  free.ranges.clear();
  const Cofactor cofactor{{0, 0, {claims.term("pole")}, {0}}, claims.term("one")};
  CHECK(judged(document_of(by_equations(free, {cofactor}))) ==
        "REJECTED proofs[0].components[0].equation[0]: the divisor a is not shown not to be zero");
}
