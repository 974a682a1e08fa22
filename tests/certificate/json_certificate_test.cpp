#include <catch2/catch.hpp>
#include <tests/recheck/hand_made.hpp>

using namespace patchproof;
using namespace patchproof::test;

TEST_CASE("A certificate as JSON, in a few lines and always the same", "[literature]") {
  const Claims claims{R"(
    scalar a
    prove square: a^2 + a^2 >= 0
    prove a_term: a == 0)"};
  const SequentProof proof =
      by_facts(claims.sequent("square"), {{{2, {claims.term("a_term")}, {}}}, {}});
  const std::string text =
      json_certificates("t", {{"t.square", "a^2 + a^2 >= 0", std::vector<SequentProof>{proof}}});
  const std::string program = nlohmann::json::parse(text)["program"];
  CHECK(program.starts_with("patchproof "));
  CHECK(text ==
        R"({
  "format": "patchproof certificate",
  "version": 1,
  "program": ")" +
            program + R"(",
  "case": "t",
  "certificates": [
    {
      "claim": "t.square",
      "statement": "a^2 + a^2 >= 0",
      "symbols": [{"name":"a","role":"scalar","type":"scalar","ordinal":0}],
      "nodes": [
        {"operation":"symbol","symbol":0},
        {"operation":"power","exponent":2,"children":[0]},
        {"operation":"sum","children":[1,1]},
        {"operation":"number","value":"0"}
      ],
      "proofs": [
        {
          "sequent": {"hypotheses":[],"ranges":[],"conclusions":[{"left":2,"relation":">=","right":3}]},
          "components": [
            {
              "conclusion": 0,
              "component": 0,
              "sign": {
                "steps": [],
                "end": {"summands":[{"coefficient":"2","squares":[0],"facts":[]}],"cofactors":[]}
              }
            }
          ],
          "not_zero": [],
          "divisors": []
        }
      ]
    }
  ]
}
)");
  CHECK(judged(text) == "RECHECKED");
}

TEST_CASE("Every operation is written and read again", "[law]") {
  const Claims claims{R"(
    param u in [0, 1]
    scalar a
    point P in R^3
    point Q in R^3
    point V[0..2]
    curve C(t) in R^3 : C^2
    patch r(s,t) : C^2
    let M = [1, a; a, 2]
    prove sums: -(a + 1)^2/2 == -1/2*a^2 - a - 1/2
    prove roots: sqrt(8)*sqrt(1/2) == 2
    prove functions: C'(u)*2 == (C_tt(u) - C_tt(u)) + C'(u) + C'(u)
    prove mixed: r_st(u, 1) - r_ts(u, 1) == 0
    prove products: dot(P, cross(P, Q)) == 0
    prove determinants: det(M) == 2 - a^2
    prove matrices: (M*transpose(M))[0,0] == 1 + a^2
    prove basis: bernstein(2, 0, u) + bernstein(2, 1, u) + bernstein(2, 2, u) == 1
    prove integrals: integral(u^2*a, u in [0, a]) == a^4/3
    prove definitions: bezier(V)(0) == V[0])"};
  const std::string label =
      GENERATE("sums", "roots", "functions", "mixed", "products", "determinants", "matrices",
               "basis", "integrals", "definitions");
  CAPTURE(label);
  const Sequent sequent = claims.sequent(label);
  SequentProof proof = by_equations(sequent, {});
  const std::size_t count = sequent.conclusions.at(0).left.type().component_count();
  for (std::size_t k = 1; k < count; ++k)
    proof.components.push_back({0, k, EquationProof{}, false});
  CHECK(judged(document_of(proof)) == "RECHECKED");
}

TEST_CASE("Two symbols with one ordinal cannot be written", "[reject]") {
  const auto symbol = [](Symbol::Role role) {
    return symbol_term(std::make_shared<const Symbol>(Symbol{"x", role, Type::scalar(), 0, 7}));
  };
  const Term scalar = symbol(Symbol::Role::scalar);
  const Term parameter = symbol(Symbol::Role::parameter);
  const Sequent sequent{{}, {}, {{scalar, Relation::equal, parameter, {}}}};
  CHECK_THROWS_WITH(document_of(by_equations(sequent, {})),
                    "the symbols 'x' and 'x' have the same ordinal");
}
