#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

const std::string energy =
    "param u, v in [0, 1]\nscalar b[0..3, 0..3], q[0..3, 0..3]\npatch p(u, v) = bezier(q)\n"
    "patch c(u, v) = bezier(discrete_coons(b))\n"
    "let E(q) = integral(q_uv^2, u in [0, 1], v in [0, 1])\n";

const std::string bar =
    "param t in [0, 1]\nscalar a, b\nscalar q[0..2]\n"
    "curve p(t) = bezier(q)\n"
    "let L(q) = integral(q'(t)^2, t in [0, 1])\n";

Decision decision_of(const std::string& statements) {
  return results_of("case t\n" + statements + "end\n").at(0).claims.at(0).decision;
}

std::string details_of(const std::string& statements) {
  std::string text;
  for (const auto& [name, value] : decision_of(statements).details)
    text += (text.empty() ? "" : "; ") + name + ": " + value;
  return text;
}

}  // namespace

TEST_CASE("the Coons patch has the least twist energy, and is the only one",
          "[minimum][literature]") {
  // Farin, Curves and Surfaces for CAGD, ch. 22. The Hessian is 2 K (x) K, K = [6/5, 3/10 ; 3/10,
  // 6/5].
  const Decision decision =
      decision_of(energy + "prove m: c minimizes E(p) over p where p == c on boundary\n");
  CHECK(to_text(decision.verdict) == "PROVED");
  CHECK(to_text(decision.evidence) == "both engines");
  CHECK(details_of(energy + "prove m: c minimizes E(p) over p where p == c on boundary\n") ==
        "Hessian: 4 x 4, positive definite; pivots: 72/25, 27/10 (2 times), 81/32; minimiser: "
        "unique");
}

TEST_CASE("the segment is the curve of least energy between its ends", "[minimum]") {
  CHECK(details_of(bar +
                   "prove m: (1-t)*a + t*b minimizes L(p) over p where p(0) == a, p(1) == b\n") ==
        "Hessian: 1 x 1, positive definite; pivots: 8/3; minimiser: unique");
  // With one end free every constant is as good.
  CHECK(
      details_of(bar + "prove m: a minimizes L(p) over p\n") ==
      "Hessian: 3 x 3, positive semidefinite; pivots: 8/3, 2; minimiser: not unique: 1 directions "
      "do not change the value");
}

TEST_CASE("what is not least is refuted by a better competitor", "[minimum]") {
  const auto check = [](const std::string& statements, const std::string& values,
                        const std::string& sides) {
    const Decision decision = decision_of(statements);
    CHECK(to_text(decision.verdict) == "REFUTED");
    std::string found;
    for (const auto& [name, value] : decision.witness.values)
      found += (found.empty() ? "" : ", ") + name + " = " + value;
    CHECK(found == values);
    CHECK(decision.witness.left + " vs " + decision.witness.right == sides);
  };
  check(bar + "refute m: (1-t)^2*a + t^2*b minimizes L(p) over p where p(0) == a, p(1) == b\n",
        "a = 0, b = 1, q[0] = 0, q[1] = 1/2, q[2] = 1", "4/3 vs 1");
  // Largest, not least.
  const std::string concave = bar + "let N(q) = -integral(q'(t)^2, t in [0, 1])\n";
  check(concave + "refute m: (1-t)*a + t*b minimizes N(p) over p where p(0) == a, p(1) == b\n",
        "a = 0, b = 0, q[0] = 0, q[1] = 1, q[2] = 0", "0 vs -4/3");
  // A linear functional has no least value.
  const std::string linear = bar + "let M(q) = integral(q(t), t in [0, 1])\n";
  check(linear + "refute m: 0 minimizes M(p) over p\n", "q[0] = -1, q[1] = 0, q[2] = 0",
        "0 vs -1/3");
}

TEST_CASE("indefinite forms are told from semidefinite ones", "[minimum]") {
  const std::string saddle = "scalar q[0..1]\nlet S(n) = n[0]*n[1]\n";
  CHECK(verdict(saddle, "[0 ; 0] minimizes S(q) over q") == "REFUTED");
  const std::string square = "scalar q[0..1]\nlet S(n) = (n[0] - n[1])^2\n";
  CHECK(verdict(square, "[2 ; 2] minimizes S(q) over q") == "PROVED");
  CHECK(verdict(square, "[2 ; 1] minimizes S(q) over q") == "REFUTED");
}

TEST_CASE("constraints may tie unknowns to each other", "[minimum]") {
  const std::string squares = "scalar q[0..1]\nlet S(n) = n[0]^2 + n[1]^2\n";
  const std::string tied = " minimizes S(q) over q where q[0] + q[1] == 1";
  CHECK(verdict(squares, "[1/2 ; 1/2]" + tied) == "PROVED");
  // Each is least when only one of the two unknowns moves.
  CHECK(verdict(squares, "[0 ; 1]" + tied) == "REFUTED");
  CHECK(verdict(squares, "[1 ; 0]" + tied) == "REFUTED");
  const std::string three = "scalar q[0..2]\nlet S(n) = n[0]^2 + 2*n[1]^2 + n[2]^2\n";
  const std::string twice = " minimizes S(q) over q where q[0] == 2*q[1], q[1] + q[2] == 7";
  CHECK(verdict(three, "[2 ; 1 ; 6]" + twice) == "PROVED");
  CHECK(verdict(three, "[0 ; 0 ; 7]" + twice) == "REFUTED");
  CHECK(verdict(three, "[14 ; 7 ; 0]" + twice) == "REFUTED");
}

TEST_CASE("a candidate has to be one of the competitors", "[minimum][reject]") {
  CHECK(verdicts(bar + "prove m: t^3 minimizes L(p) over p\n") ==
        "m ERROR (the candidate is not among the competitors: no control points of theirs give "
        "it)\n");
  CHECK(
      verdicts(bar + "prove m: (1-t)*a + t*b minimizes L(p) over p where p(0) == b, p(1) == b\n") ==
      "m ERROR (the candidate does not satisfy the constraint p(0) == b)\n");
  CHECK(verdicts(bar + "prove m: a minimizes L(p) over p where p(0)^2 == a^2\n") ==
        "m UNKNOWN (the equations are not linear in the unknowns)\n");
}

TEST_CASE("functionals that are not quadratic are not decided", "[minimum][reject]") {
  const std::string not_quadratic =
      "m UNKNOWN (the functional is not a polynomial of degree 2 in the control points of the "
      "competitor)\n";
  CHECK(verdicts(bar +
                 "let Q(q) = integral(q'(t)^4, t in [0, 1])\nprove m: a minimizes Q(p) over p\n") ==
        not_quadratic);
  CHECK(verdicts(bar + "let Q(q) = 1/(1 + q(0)^2)\nprove m: a minimizes Q(p) over p\n") ==
        not_quadratic);
  CHECK(verdicts(bar + "let Q(q) = exp(q(0))\nprove m: a minimizes Q(p) over p\n") ==
        not_quadratic);
  CHECK(
      verdicts(bar + "scalar k\nlet Q(q) = k^2*q(0)^2\nprove m: 0 minimizes Q(p) over p\n") ==
      "m UNKNOWN (the Hessian of the functional contains symbols, and its sign was not settled)\n");
}

TEST_CASE("a Hessian with symbols is refuted by numbers only", "[minimum]") {
  const std::string given = "param t in [0, 1]\nscalar k\nscalar q[0..2]\ncurve p(t) = bezier(q)\n";
  CHECK(verdict(given, "0 minimizes k*p(0)^2 over p") == "REFUTED");
  CHECK(verdict(given + "assume positive: k > 0\n", "0 minimizes k*p(0)^2 over p") == "UNKNOWN");
  CHECK(verdict(given, "0 minimizes integral(p(t)^2, t in [0, 1]) over p where k*p(0) == 0") ==
        "PROVED IF");
}

TEST_CASE("assumptions about what is given are used for minima", "[minimum]") {
  const std::string given = bar + "assume same: a == b\n";
  CHECK(verdict(given, "a minimizes L(p) over p where p(0) == a, p(1) == b") == "PROVED");
  CHECK(verdicts(given + "assume idle: a > 0\n"
                         "prove m: a minimizes L(p) over p where p(0) == a, p(1) == b\n") ==
        "m PROVED uses same\n");
  CHECK(verdict(bar, "a minimizes L(p) over p where p(0) == a, p(1) == b") == "ERROR");
  const std::string never = bar + "assume one: a == 1\nassume two: a == 2\n";
  CHECK(verdict(never, "a minimizes L(p) over p where p(0) == a") == "VACUOUS");
}

}  // namespace patchproof
