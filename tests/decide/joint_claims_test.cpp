#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

TEST_CASE("Bézier curves join with C^k under the conditions of the textbook", "[literature]") {
  // Farin, Curves and Surfaces for CAGD, 7.2: C^1 when 3(b3 - b2) == 3(c1 - c0).
  const std::string curves = R"~(
  point b[0..3], c[0..3]
  curve p(t) = bezier(b)
  curve q(t) = bezier(c)
)~";
  CHECK(verdicts(curves + R"~(
  assume meet: b[3] == c[0]
  prove c0: C^0 joint of p at t = 1 and q at t = 0
  refute c1: C^1 joint of p at t = 1 and q at t = 0
)~") == "c0 PROVED uses meet\nc1 REFUTED\n");
  CHECK(verdicts(curves + R"~(
  assume meet: b[3] == c[0]
  assume smooth: c[1] == 2*b[3] - b[2]
  prove c1: C^1 joint of p at t = 1 and q at t = 0
  refute c2: C^2 joint of p at t = 1 and q at t = 0
  refute wrong_end: C^1 joint of p at t = 1 and q at t = 1
  refute swapped: C^0 joint of p at t = 0 and q at t = 1
)~") == "c1 PROVED uses meet uses smooth\nc2 REFUTED\nwrong_end REFUTED\nswapped REFUTED\n");
}

TEST_CASE("where the direction turns round, odd derivatives change their sign") {
  // q is p run through backwards from the joint on: q(t) = r(t) means p(1 - t) reflected.
  CHECK(verdicts(R"~(
  param t in [0, 1]
  curve p(t) = (t, t^2)
  curve next(t) = (1 + t, (1 + t)^2)
  curve back(t) = next(1 - t)
  curve before(t) = p(1 - t)
  prove forward: C^2 joint of p at t = 1 and next at t = 0
  prove second_reversed: C^2 joint of p at t = 1 and back at t = 1
  prove first_reversed: C^2 joint of before at t = 0 and next at t = 0
  prove both_reversed: C^2 joint of before at t = 0 and back at t = 1
  refute folded: C^1 joint of p at t = 1 and before at t = 0
  prove folded_position: C^0 joint of p at t = 1 and before at t = 0
)~") == R"~(forward PROVED
second_reversed PROVED
first_reversed PROVED
both_reversed PROVED
folded REFUTED
folded_position PROVED
)~");
}

TEST_CASE("a fold has equal second derivatives and opposite first ones") {
  CHECK(verdicts(R"~(
  param t in [0, 1]
  curve p(t) = (t^2, 0)
  curve q(t) = (1 - t^2, 0)
  prove even: C^0 joint of p at t = 0 and p at t = 0
  prove flat: C^1 joint of p at t = 0 and p at t = 0
  prove symmetric: C^5 joint of p at t = 0 and p at t = 0
  refute at_one: C^1 joint of p at t = 1 and p at t = 1
)~") == "even PROVED\nflat PROVED\nsymmetric PROVED\nat_one REFUTED\n");
}

TEST_CASE("patches join along an edge, for all parameters along it") {
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  point a[0..3, 0..2], b[0..3, 0..2]
  patch P(u, v) = bezier(a)
  patch R(u, v) = bezier(b)
  assume r0: b[0,0] == a[0,2], b[1,0] == a[1,2], b[2,0] == a[2,2], b[3,0] == a[3,2]
  prove position: C^0 joint of P at v = 1 and R at v = 0
  refute tangent: C^1 joint of P at v = 1 and R at v = 0
  refute other_edge: C^0 joint of P at u = 1 and R at u = 0
)~") == "position PROVED uses r0\ntangent REFUTED\nother_edge REFUTED\n");
}

TEST_CASE("an edge in u may meet an edge in v") {
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  patch P(u, v) = (u, v, u*v)
  patch turned(u, v) = (v + 1, u, (v + 1)*u)
  prove across: C^3 joint of P at u = 1 and turned at v = 0
  refute along: C^0 joint of P at u = 1 and turned at u = 0
)~") == "across PROVED\nalong REFUTED\n");
}

TEST_CASE("edges lie at the ends of the declared range") {
  CHECK(verdicts(R"~(
  scalar a, b, c
  param t in [a, b]
  param s in [b, c]
  curve p(t) = (t, t^2)
  curve q(s) = (s, s^2)
  prove long: C^4 joint of p at t = b and q at s = b
  refute turned: C^1 joint of p at t = a and q at s = b
)~") == "long PROVED\nturned REFUTED\n");
}

TEST_CASE("a joint of unknown functions needs the derivatives it speaks of") {
  CHECK(verdicts(R"~(
  curve p(t), q(t) : C^1
  assume meet: p(1) == q(0)
  assume tangent: p'(1) == q'(0)
  prove first: C^1 joint of p at t = 1 and q at t = 0
  prove second: C^2 joint of p at t = 1 and q at t = 0
)~") == R"~(first PROVED uses meet uses tangent
second ERROR (a derivative of order 2 of 'p', which is only assumed C^1)
)~");
}

TEST_CASE("a joint determines the points near it") {
  CHECK(verdicts(R"~(
  point b[0..3], c[0..3]
  curve p(t) = bezier(b)
  curve q(t) = bezier(c)
  derive c0: c[0], c[1], c[2] from C^2 joint of p at t = 1 and q at t = 0
         gives b[3], 2*b[3] - b[2], 4*b[3] - 4*b[2] + b[1]
  refute free: C^3 joint of p at t = 1 and q at t = 0 using c0
)~") == "c0 PROVED\nfree REFUTED\n");
}

}  // namespace patchproof
