#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

// "u = 1/2, x = 0: left vs right at component".
std::string witness_of(const std::string& declarations, const std::string& proposition) {
  const auto results =
      results_of("case t\n" + declarations + "\nrefute p: " + proposition + "\nend\n");
  const Decision& decision = results.at(0).claims.at(0).decision;
  if (decision.verdict != Verdict::refuted) return to_text(decision.verdict);
  std::string result;
  for (const auto& [name, value] : decision.witness.values)
    result += (result.empty() ? "" : ", ") + name + " = " + value;
  const std::string component =
      decision.witness.component.empty() ? "" : " at " + decision.witness.component;
  return result + ": " + decision.witness.left + " vs " + decision.witness.right + component;
}

}  // namespace

TEST_CASE("a witness is small: few values differ from zero") {
  CHECK(witness_of("scalar x, y", "x == y") == "x = 0, y = 1: 0 vs 1");
  CHECK(witness_of("scalar x, y", "x*y == 0") == "x = 1, y = 1: 1 vs 0");
  CHECK(witness_of("scalar x", "x == 1") == "x = 0: 0 vs 1");
  CHECK(witness_of("param u in [0, 1]", "u*(1-u) == 0") == "u = 1/2: 1/4 vs 0");
  CHECK(witness_of("param u in [2, 3]", "u == 0") == "u = 2: 2 vs 0");
  CHECK(witness_of("", "1 == 2") == ": 1 vs 2");
}

TEST_CASE("a witness for an unknown function is a polynomial that satisfies the assumptions") {
  CHECK(witness_of("param u in [0, 1]\nscalar f(u) : C^1", "f(u) == f(0)") ==
        "u = 1, f(u) = u: 1 vs 0");
  CHECK(witness_of("param u in [0, 1]\nscalar f(u) : C^1\nassume ends: f(0) == 0, f(1) == 0",
                   "f(1/2) == 0") == "f(u) = -4*u^2 + 4*u: 1 vs 0");
  CHECK(witness_of("scalar f(t) : C^1", "f'(0) == f(0)").find("f(t) = ") != std::string::npos);
}

TEST_CASE("a witness says which component of the two sides differs") {
  CHECK(witness_of("scalar x", "(x, x + 1) == (x, x)") == "x = 0: 1 vs 0 at .y");
  CHECK(witness_of("scalar x", "[x, 0 ; 1, x] == [x, 0 ; 0, x]") == "x = 0: 1 vs 0 at [1,0]");
  CHECK(witness_of("point P in R^3", "P == (0, 0, P.z)") == "P = (1, 0, 0): 1 vs 0 at .x");
}

TEST_CASE("a witness for numbers alone is their certified decimals") {
  CHECK(witness_of("", "sqrt(2) == 1.41421356") ==
        ": sqrt(2) = 1.414213562373… vs 35355339/25000000");
  CHECK(witness_of("", "pi == 22/7") == ": pi = 3.141592653589… vs 22/7");
}

TEST_CASE("values that assumptions fix are part of the witness") {
  const std::string found = witness_of("scalar a, b\nassume s: b == a + 3", "a == 5");
  CHECK(found == "a = 0, b = 3: 0 vs 5");
  CHECK(witness_of("scalar a, b\nassume o: a < b", "a == b") == "a = 0, b = 1: 0 vs 1");
  CHECK(witness_of("scalar a\nassume o: a >= 1000", "a == 5") == "a = 1000: 1000 vs 5");
}

}  // namespace patchproof
