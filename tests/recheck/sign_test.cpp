#include <catch2/catch.hpp>
#include <tests/recheck/hand_made.hpp>

using namespace patchproof;
using namespace patchproof::test;

namespace {

const std::string sign = "/certificates/0/proofs/0/components/0/sign";

const Claims& bounds() {
  static const Claims claims{R"(
    param u in [0, 1]
    scalar a, b
    assume positive: a > 0
    assume order: b >= a
    prove inside: u*(1-u) >= 0
    prove larger: b > 0
    prove square: a^2 - 2*a*b + b^2 >= 0
    prove product: a*b > 0
    prove differs: 0 != a + b
    prove nothing: b > a
    prove modulus: a^2*(b - 2*a)^2 >= 0
    prove b_term: b == 0
    prove difference: a - b == 0
    prove cut_at: b - 2*a == 0
    prove a_term: a == 0)"};
  return claims;
}

// The facts: 0 is u, 1 is 1-u, 2 is a, 3 is b-a.
std::string shown(const std::string& label, const Combination& combination) {
  return judged(document_of(by_facts(bounds().sequent(label), combination)));
}

Summand product(std::vector<std::pair<std::size_t, unsigned>> facts, const Rational& factor = 1) {
  return {factor, {}, std::move(facts)};
}

}  // namespace

TEST_CASE("Products and squares of facts show signs", "[law]") {
  CHECK(shown("inside", {{product({{0, 1}, {1, 1}})}, {}}) == "RECHECKED");
  CHECK(shown("larger", {{product({{2, 1}}), product({{3, 1}})}, {}}) == "RECHECKED");
  CHECK(shown("square", {{{1, {bounds().term("difference")}, {}}}, {}}) == "RECHECKED");
  // a*b = a^2 + a*(b-a)
  CHECK(shown("product", {{product({{2, 2}}), product({{2, 1}, {3, 1}})}, {}}) == "RECHECKED");
}

TEST_CASE("A wrong sum is rejected", "[reject]") {
  CHECK(shown("inside", {{product({{0, 1}})}, {}}) ==
        "REJECTED proofs[0].components[0].end: -u^2 + u is not the sum: -u^2 is left");
  CHECK(shown("inside", {{product({{0, 1}, {1, 1}}, 2)}, {}}) ==
        "REJECTED proofs[0].components[0].end: -u^2 + u is not the sum: u^2 - u is left");
  CHECK(shown("larger", {{product({{2, 1}})}, {}}) ==
        "REJECTED proofs[0].components[0].end: b is not the sum: -a + b is left");
  CHECK(shown("inside", {{product({{4, 1}})}, {}}) ==
        "REJECTED proofs[0].components[0].end.summands[0]: there is no fact 4, only 4");
}

TEST_CASE("What may be zero is not positive", "[reject]") {
  CHECK(shown("nothing", {{product({{3, 1}})}, {}}) ==
        "REJECTED proofs[0].components[0].end: -a + b is not shown to be positive: no summand is");
  const std::string weak = document_of(
      by_facts(bounds().sequent("larger"), {{product({{2, 1}}), product({{3, 1}})}, {}}));
  CHECK(judged(changed(weak, "/certificates/0/proofs/0/sequent/hypotheses/0/relation", ">=")) ==
        "REJECTED proofs[0].components[0].end: b is not shown to be positive: no summand is");
}

TEST_CASE("A step is a fact for what follows, as strict as it was shown", "[law]") {
  const SignProof::Step step{
      bounds().term("b_term"), true, {{product({{2, 1}}), product({{3, 1}})}, {}}};
  SequentProof proof = by_facts(bounds().sequent("product"), {});
  proof.components[0].why = SignProof{{step}, Combination{{product({{2, 1}, {4, 1}})}, {}}};
  const std::string good = document_of(proof);
  CHECK(judged(good) == "RECHECKED");
  CHECK(judged(changed(good, sign + "/steps/0/strict", false)) ==
        "REJECTED proofs[0].components[0].end: a*b is not shown to be positive: no summand is");
  CHECK(judged(changed(good, sign + "/steps/0/why/summands", nlohmann::json::array())) ==
        "REJECTED proofs[0].components[0].steps[0]: b is not the sum: b is left");
  CHECK(judged(changed(good, sign + "/steps", nlohmann::json::array())) ==
        "REJECTED proofs[0].components[0].end.summands[0]: there is no fact 4, only 4");
  // A step cannot use itself.
  const nlohmann::json itself = {{"fact", 4}, {"exponent", 1}};
  CHECK(judged(changed(good, sign + "/steps/0/why/summands/0/facts/0", itself)) ==
        "REJECTED proofs[0].components[0].steps[0].summands[0]: there is no fact 4, only 4");
}

TEST_CASE("A cut needs both cases, and each has its own fact", "[law]") {
  const Combination half{{{1, {bounds().term("a_term")}, {{4, 2}}}}, {}};
  SequentProof proof = by_facts(bounds().sequent("modulus"), {});
  proof.components[0].why = SignProof{
      {}, SignProof::Cut{bounds().term("cut_at"), {SignProof{{}, half}, SignProof{{}, half}}}};
  const std::string good = document_of(proof);
  CHECK(judged(good) == "RECHECKED");
  nlohmann::json one = nlohmann::json::parse(
      good)["certificates"][0]["proofs"][0]["components"][0]["sign"]["cut"]["cases"];
  one.erase(1);
  CHECK(judged(changed(good, sign + "/cut/cases", one)) ==
        "unreadable: certificates[0].proofs[0].components[0].sign.cut.cases: a cut has two cases");
  // The fact of the second case is 2*a - b: its first power has the other sign.
  nlohmann::json odd = nlohmann::json::parse(good);
  const std::string place = sign + "/cut/cases/1/end/summands/0/facts/0/exponent";
  CHECK(judged(changed(good, place, 1))
            .starts_with("REJECTED proofs[0].components[0].cut.cases[1].end: "));
}

TEST_CASE("Scalars differ when their difference or its negative is positive", "[law]") {
  // 0 - (a + b) is negative: a + b = 2*a + (b - a)
  SequentProof proof =
      by_facts(bounds().sequent("differs"), {{product({{2, 1}}, 2), product({{3, 1}})}, {}});
  proof.components[0].negative = true;
  CHECK(judged(document_of(proof)) == "RECHECKED");
  proof.components[0].negative = false;
  CHECK(judged(document_of(proof))
            .starts_with("REJECTED proofs[0].components[0].end: -a - b is not the sum: "));
  const std::string good =
      document_of(by_facts(bounds().sequent("inside"), {{product({{0, 1}, {1, 1}})}, {}}));
  nlohmann::json json = nlohmann::json::parse(good);
  json["certificates"][0]["proofs"][0]["components"][0]["negative"] = true;
  CHECK(judged(json.dump()) == "REJECTED proofs[0].components[0]: 'negative' belongs to != only");
}

TEST_CASE("Coefficients are positive, exponents too", "[reject]") {
  const std::string good =
      document_of(by_facts(bounds().sequent("inside"), {{product({{0, 1}, {1, 1}})}, {}}));
  CHECK(judged(changed(good, sign + "/end/summands/0/coefficient", "-1")) ==
        "unreadable: certificates[0].proofs[0].components[0].sign.end.summands[0].coefficient: a "
        "positive number is needed here");
  CHECK(judged(changed(good, sign + "/end/summands/0/facts/0/exponent", 0)) ==
        "unreadable: certificates[0].proofs[0].components[0].sign.end.summands[0].facts[0]."
        "exponent: 0 is no exponent here");
}
