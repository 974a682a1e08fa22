// What must not be concluded: each rule of the checker, where it would be too strong.
#include <catch2/catch.hpp>
#include <tests/recheck/hand_made.hpp>

using namespace patchproof;
using namespace patchproof::test;

namespace {

const std::string proof_place = "/certificates/0/proofs/0";

const Claims& poles() {
  static const Claims claims{R"(
    scalar a
    scalar f(t) = 1/t
    scalar g(t) = t^2
    assume root: a^2 == 2
    prove positive: 1 >= 0
    prove even: 2 == a^2
    prove pole: 1/a == 0
    prove a_term: a == 0
    prove minus: -a == 0
    prove one: 1 == 0
    prove applied: f(a) == f(a)
    prove argument: g(1/a) == g(1/a)
    prove twice: 1/(1/a) == 1/(1/a)
    prove product: a*(1/a) == a*(1/a)
    prove power: a^(-1) == a^(-1)
    prove basis: bernstein(1, 0, 1/a) == bernstein(1, 0, 1/a)
    prove square: a^2 >= 0
    prove strict: a^2 > 0)"};
  return claims;
}

Summand square_of(const std::string& label) { return {1, {poles().term(label)}, {}}; }

const std::string pole = "the divisor a is not shown not to be zero";

}  // namespace

TEST_CASE("Every operation remembers what it divides by", "[law]") {
  const std::string label = GENERATE("applied", "argument", "twice", "product", "power", "basis");
  CAPTURE(label);
  CHECK(judged(document_of(by_equations(poles().sequent(label), {}))) ==
        "REJECTED proofs[0].sequent: " + pole);
}

TEST_CASE("Every part of a proof is kept from dividing by zero", "[law]") {
  const auto end = "REJECTED proofs[0].components[0]";
  const Sequent positive = poles().sequent("positive");
  CHECK(judged(document_of(by_facts(positive, {{square_of("pole")}, {}}))) ==
        end + std::string{".end.summands[0]: "} + pole);
  SequentProof proof = by_facts(positive, {});
  const Combination one{{{1, {}, {}}}, {}};
  proof.components[0].why =
      SignProof{{}, SignProof::Cut{poles().term("pole"), {SignProof{{}, one}, SignProof{{}, one}}}};
  CHECK(judged(document_of(proof)) == end + std::string{".cut: "} + pole);
  const SignProof::Step step{poles().term("pole"), false, {}};
  proof.components[0].why = SignProof{{step}, one};
  CHECK(judged(document_of(proof)) == end + std::string{".steps[0]: "} + pole);
  const Cofactor cofactor{{0, 0, {}, {}}, poles().term("pole")};
  CHECK(judged(document_of(by_equations(poles().sequent("even"), {cofactor}))) ==
        end + std::string{".equation[0]: "} + pole);
  proof = by_facts(positive, one);
  proof.not_zero = {{poles().term("pole"), std::nullopt, SignProof{{}, one}, false}};
  CHECK(judged(document_of(proof)) == "REJECTED proofs[0].not_zero[0]: " + pole);
  proof.not_zero = {};
  proof.divisors = {{poles().term("pole"), {}}};
  CHECK(judged(document_of(proof)) == "REJECTED proofs[0].divisors[0]: " + pole);
}

TEST_CASE("A square is not positive by itself", "[reject]") {
  CHECK(judged(document_of(by_facts(poles().sequent("square"), {{square_of("a_term")}, {}}))) ==
        "RECHECKED");
  CHECK(judged(document_of(by_facts(poles().sequent("strict"), {{square_of("a_term")}, {}}))) ==
        "REJECTED proofs[0].components[0].end: a^2 is not shown to be positive: no summand is");
}

TEST_CASE("The second case of a cut knows the negative, and not the scalar", "[law]") {
  const auto with = [](const std::string& known) {
    const SignProof::Step step{poles().term(known), false, {{{1, {}, {{0, 1}}}}, {}}};
    const Combination end{{{1, {}, {{1, 2}}}}, {}};
    const SignProof first{{}, Combination{{{1, {}, {{0, 2}}}}, {}}};
    SequentProof proof = by_facts(poles().sequent("square"), {});
    proof.components[0].why =
        SignProof{{}, SignProof::Cut{poles().term("a_term"), {first, SignProof{{step}, end}}}};
    return judged(document_of(proof));
  };
  CHECK(with("minus") == "RECHECKED");
  CHECK(with("a_term") ==
        "REJECTED proofs[0].components[0].cut.cases[1].steps[0]: a is not the sum: 2*a is left");
}

TEST_CASE("Points that differ need not differ in a coordinate", "[reject]") {
  const Claims claims{R"(
    point P in R^2
    point Q in R^2
    assume apart: P != Q
    prove quotient: 1/(P.x - Q.x) == 1/(P.x - Q.x)
    prove again: Q != P
    prove first: P.x - Q.x == 0)"};
  SequentProof proof = by_equations(claims.sequent("quotient"), {});
  proof.not_zero = {{claims.term("first"), 0, std::nullopt, false}};
  CHECK(judged(document_of(proof)) ==
        "REJECTED proofs[0].not_zero[0]: hypothesis 0 does not say that scalars differ");
  CHECK(judged(document_of(SequentProof{claims.sequent("again"), {}, {}, {}})) ==
        "REJECTED proofs[0].sequent.conclusions[0]: no component is shown");
}

TEST_CASE("A range that depends on another parameter moves with it", "[reject]") {
  const Claims claims{R"(
    param u in [0, 1]
    scalar a
    param v in [a, u]
    param w in [0, 2]
    param x in [-1, 1]
    scalar f(s) : C^2
    scalar g(s) : C^2
    assume zero: f(u) + g(v) == 0
    prove here: f(u) + g(v) == 0
    prove one: 1 == 0
    prove zero_term: 0 == 1
    prove a_term: a == 0
    prove u_term: u == 0
    prove v_term: v == 0
    prove w_term: w == 0
    prove x_term: x == 0
    prove half: u/2 == 0)"};
  const auto at = [&](const std::string& u, const std::string& v, int order) {
    Sequent sequent = claims.sequent("here");
    // Ranges of all parameters, also of those that stand only in the values.
    for (const char* other : {"w_term", "x_term"})
      for (const ParameterRange& range : claims.sequent(other).ranges)
        if (range.parameter->name == "w" || range.parameter->name == "x") {
          bool known = false;
          for (const ParameterRange& have : sequent.ranges)
            known = known || have.parameter->ordinal == range.parameter->ordinal;
          if (!known) sequent.ranges.push_back(range);
        }
    const Cofactor cofactor{{0, 0, {claims.term(u), claims.term(v)}, {order, 0}},
                            claims.term("one")};
    const std::string found = judged(document_of(by_equations(sequent, {cofactor})));
    const std::string start = " proofs[0].components[0].equation[0]: ";
    const std::size_t place = found.find(start);
    return place == std::string::npos
               ? found
               : found.substr(0, place + 1) + found.substr(place + start.size());
  };
  CHECK(at("u_term", "v_term", 0) == "RECHECKED");
  CHECK(at("zero_term", "v_term", 0) == "UNKNOWN whether v is in the range of 'v'");
  CHECK(at("zero_term", "a_term", 0) == "UNKNOWN whether a is in the range of 'v'");
  CHECK(at("w_term", "v_term", 0) == "UNKNOWN whether w is in the range of 'u'");
  CHECK(at("x_term", "v_term", 0) == "UNKNOWN whether x is in the range of 'u'");
  CHECK(at("half", "u_term", 0) == "UNKNOWN whether u is in the range of 'v'");
  CHECK(at("u_term", "v_term", 1) == "UNKNOWN a derivative in 'u', on which another range depends");
}

TEST_CASE("An integral over a pole is not worked out", "[reject]") {
  const Claims claims{R"(
    param u in [0, 1]
    scalar a
    prove pole: integral(a/(u - 1/2)^2, u in [0, 1]) == -4*a)"};
  CHECK(judged(document_of(by_equations(claims.sequent("pole"), {}))) ==
        "UNKNOWN proofs[0].sequent: an integral with a divisor that depends on its variable");
}

TEST_CASE("One coordinate of a point of any dimension is in no statement", "[reject]") {
  const Claims claims{R"(
    scalar a
    point P
    assume same: a == a
    prove itself: a*P == P*a)"};
  const std::string good = document_of(by_equations(claims.sequent("itself"), {}));
  REQUIRE(judged(good) == "RECHECKED");
  nlohmann::json json = nlohmann::json::parse(good);
  auto& nodes = json["certificates"][0]["nodes"];
  auto& sequent = json["certificates"][0]["proofs"][0]["sequent"];
  const std::size_t last = nodes.size() - 1;
  nodes.push_back({{"operation", "component"}, {"indices", {0}}, {"children", {last}}});
  sequent["conclusions"][0] = {{"left", last + 1}, {"relation", "=="}, {"right", last + 1}};
  CHECK(
      judged(json.dump()) ==
      "unreadable: certificates[0].proofs[0].sequent.conclusions[0].left: a coordinate of a point "
      "of any dimension stands in a statement");
  CHECK(judged(changed(good, proof_place + "/sequent/conclusions/0/relation", "<=")) ==
        "unreadable: certificates[0].proofs[0].sequent.conclusions[0]: only scalars are in an "
        "order");
  CHECK(judged(changed(good, proof_place + "/sequent/conclusions/0/left", 0)) ==
        "unreadable: certificates[0].proofs[0].sequent.conclusions[0]: sides of different types");
}
