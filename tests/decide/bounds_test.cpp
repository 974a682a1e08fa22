#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

Decision decision_of(const std::string& declarations, const std::string& proposition) {
  return results_of("case t\n" + declarations + "\nprove p: " + proposition + "\nend\n")
      .at(0)
      .claims.at(0)
      .decision;
}

std::string witness_of(const Decision& decision) {
  std::string text;
  for (const auto& [name, value] : decision.witness.values)
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  return text;
}

const std::string square = "param u, v in [0, 1]";

}  // namespace

TEST_CASE("bounds that are attained inside are proved, and no smaller ones", "[literature]") {
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  scalar T
  assume up: T > 0
  patch h(u, v) = H13(u)*H13(v)
  prove slope: 0 <= H13(u) <= 4/27
  prove bulge: h(u,v) <= 16/729
  prove scaled: T*h(u,v) <= 16*T/729
  prove turned: -T*h(u,v) >= -16*T/729
  refute smaller: T*h(u,v) <= 15*T/729
  refute narrow: h(u,v) <= 16/729 - 1/1000000000
  refute strict: T*h(u,v) < 16*T/729
)~") == R"~(slope PROVED
bulge PROVED
scaled PROVED uses up
turned PROVED uses up
smaller REFUTED
narrow REFUTED
strict REFUTED
)~");
}

TEST_CASE("without the sign of a factor its product has no sign") {
  CHECK(verdict(square + "\nscalar T", "T*H13(u)*H13(v) <= 16*T/729") == "REFUTED");
  CHECK(verdict(square + "\nscalar T\nassume T >= 0", "T*H13(u)*H13(v) <= 16*T/729") == "PROVED");
  CHECK(verdict(square + "\nscalar T\nassume T < 0", "T*H13(u)*H13(v) <= 16*T/729") == "REFUTED");
  CHECK(verdict(square + "\nscalar T\nassume T < 0", "T*H13(u)*H13(v) >= 16*T/729") == "PROVED");
}

TEST_CASE("a zero at a corner is an answer of its own") {
  const Decision corner = decision_of(square, "u^2 + v > 0");
  CHECK(corner.verdict == Verdict::refuted);
  CHECK(corner.reason == "left - right is never negative on the box; zero at u = 0, v = 0");
  CHECK(witness_of(corner) == "u = 0, v = 0");
  const Decision turned = decision_of(square, "0 < u^2 + v");
  CHECK(turned.reason == "right - left is never negative on the box; zero at u = 0, v = 0");
  const Decision inside = decision_of(square, "(3*u - 1)^2 + (2*v - 1)^2 != 0");
  CHECK(inside.reason == "left - right does not change its sign; zero at u = 1/3, v = 1/2");
  const Decision both = decision_of(square, "u - v > 0");
  CHECK(both.verdict == Verdict::refuted);
  CHECK(both.reason.empty());
}

TEST_CASE("a polynomial that is slightly negative in a small region is refuted there") {
  const std::string p = "(3*u - 1)^2 - 3*u*v + v + (3*v - 1)^2 + u - 1/3";
  const Decision decision = decision_of(square, p + " >= -1/1000000");
  INFO(decision.reason);
  CHECK((decision.verdict == Verdict::refuted || decision.verdict == Verdict::proved));
  const Decision narrow = decision_of(square, "(u - 1/3)^2 + (v - 1/3)^2 >= 1/1000000000000");
  CHECK(narrow.verdict == Verdict::refuted);
  CHECK(witness_of(narrow) == "u = 1/3, v = 1/3");
}

TEST_CASE("boxes are counted where they were needed") {
  const Decision plain = decision_of(square, "u*v >= 0");
  CHECK(plain.subdivision.boxes == 0);
  const Decision tree = decision_of(square, "H13(u)*H13(v) <= 16/729");
  CHECK(tree.verdict == Verdict::proved);
  CHECK(tree.subdivision.boxes > 1);
  CHECK(tree.subdivision.depth > 1);
}

TEST_CASE("coefficients with symbols have the signs that the assumptions give them") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar a, b, c
  assume order: 0 < a, a < b, b < c
  prove positive: a*(1-u)^2 + 2*b*u*(1-u) + c*u^2 > 0
  prove above: a*(1-u)^2 + 2*b*u*(1-u) + c*u^2 >= a
  prove subdivided: a*(1-u)^2 - a*u*(1-u) + c*u^2 > 0
  refute below: a*(1-u)^2 + 2*b*u*(1-u) + c*u^2 >= b
  prove product: a*b*u + b*c > 0
  prove quotient: u/(a + b) >= 0
)~") == R"~(positive PROVED uses order
above PROVED uses order
subdivided PROVED uses order
below REFUTED
product PROVED uses order
quotient PROVED uses order
)~");
}

TEST_CASE("a scalar between numbers is a parameter as good as any") {
  CHECK(
      verdicts(R"~(
  scalar a, b
  assume range: 0 <= a, a <= 1, 0 < b, b < 1
  prove hermite: a*(1-a)^2 <= 4/27
  prove inside: b*(1-b) > 0
  refute end: a*(1-a) > 0
  prove both: a*(1-a)^2*b*(1-b)^2 <= 16/729
)~") ==
      "hermite PROVED uses range\ninside PROVED uses range\nend REFUTED\nboth PROVED uses range\n");
}

TEST_CASE("a factor that may be zero does not make a product positive") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar a, b, c, d
  assume order: a <= b, c < 0, d < 0
  prove weakly: (b - a)*(1 + u - u^2) >= 0
  refute strictly: (b - a)*(1 + u - u^2) > 0
  refute apart: (b - a)*(1 + u - u^2) != 0
  prove negative: (c + d)*(1 + u - u^2) < 0
  prove bound: (c + d)*H13(u) >= 4*(c + d)/27
  refute attained: (c + d)*H13(u) > 4*(c + d)/27
  refute sign: (c + d)*H13(u) <= 4*(c + d)/27
)~") == R"~(weakly PROVED uses order
strictly REFUTED
apart REFUTED
negative PROVED uses order
bound PROVED uses order
attained REFUTED
sign REFUTED
)~");
}

TEST_CASE("numbers that bound a scalar do not hide what else is assumed of it") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar a, b
  assume order: 0 <= a, a <= b, b <= 1
  prove combined: (b - a)*(1 - u) + b*u^2 >= 0
  refute turned: (a - b)*(1 - u) + b*u^2 >= 0
)~") == "combined PROVED uses order\nturned REFUTED\n");
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  scalar k
  assume below: 0 <= k, k < 8
  prove positive: 4 + 2*k*((1 - 2*u)*v*(1 - v) + (1 - 2*v)*u*(1 - u)) > 0
  refute further: 4 + 2*k*((1 - 2*u)*v*(1 - v) + (1 - 2*v)*u*(1 - u)) > 1/100
)~") == "positive PROVED uses below\nfurther REFUTED\n");
}

TEST_CASE("squares are not negative, nor are vectors different that meet") {
  CHECK(verdicts(R"~(
  param t in [0, 1]
  scalar x, y
  prove square: x^2 + y^2 >= 2*x*y
  refute strictly: x^2 + y^2 > 2*x*y
  prove apart: (t, 1 - t) != (0, 0)
  refute meet: (t^2, 2*t - 1) != (1/4, 0)
  refute sign: x^2 + y^2 >= 3*x*y
)~") == "square PROVED\nstrictly REFUTED\napart PROVED\nmeet REFUTED\nsign REFUTED\n");
}

TEST_CASE("what no fraction refutes and no boxes decide is unknown, and says where") {
  const Decision root = decision_of("param u in [0, 1]", "(2*u^2 - 1)^2 > 0");
  CHECK(root.verdict == Verdict::unknown);
  CHECK(root.reason ==
        "limit of subdivision: the sign of left - right is not decided near u = 29/41");
  const Decision change = decision_of("param u in [0, 1]", "2*u^2 - 1 != 0");
  CHECK(change.verdict == Verdict::unknown);
  CHECK(
      change.reason ==
      "left - right changes its sign, so it is zero somewhere, but not at any of the points tried");
  CHECK(verdict("param u in [0, 1]", "(2*u^2 - 1)^2 >= 0") == "PROVED");
}

TEST_CASE("the sign of a quotient is that of its factors", "[law]") {
  CHECK(verdict(square, "1/(1 + u) - 1/2 >= 0") == "PROVED");
  CHECK(verdict(square, "u/(u - 2) <= 0") == "PROVED");
  CHECK(verdict(square, "1/((u - 2)*(v + 1)) < 0") == "PROVED");
  CHECK(verdict(square, "1/(u - 2)^2 >= 1/4") == "PROVED");
  CHECK(verdict(square, "1/(u - 2)^3 <= -1/8") == "PROVED");
  CHECK(verdict(square, "1/(u - 2)^3 >= -1/8") == "REFUTED");
}

}  // namespace patchproof
