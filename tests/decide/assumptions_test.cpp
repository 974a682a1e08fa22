#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

TEST_CASE("a proof names the assumptions it cannot do without") {
  CHECK(verdicts(R"~(
  scalar a, b, c, d
  assume first: a == b
  assume second: b == c
  assume third: c == d
  prove one: a == b
  prove two: a == c
  prove three: a == d
  prove none: a + b == b + a
  prove last: c - d == 0
)~") == R"~(one PROVED uses first
two PROVED uses first uses second
three PROVED uses first uses second uses third
none PROVED
last PROVED uses third
)~");
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  curve C1(u), C2(u), D1(v), D2(v)
  assume south_west: C1(0) == D1(0)
  assume south_east: C1(1) == D2(0)
  assume north_west: C2(0) == D1(1)
  assume north_east: C2(1) == D2(1)
  patch r(u,v) = coons(C1, C2, D1, D2)
  prove south: r(u, 0) == C1(u)
  prove north: r(u, 1) == C2(u)
  prove west: r(0, v) == D1(v)
  prove east: r(1, v) == D2(v)
  prove middle: r_uv(u, v) == r_vu(u, v)
)~") == R"~(south PROVED uses south_west uses south_east
north PROVED uses north_west uses north_east
west PROVED
east PROVED
middle ERROR (a derivative of order 1 of 'C1', which is only assumed C^0)
)~");
}

TEST_CASE("assumptions without a label are named by their number") {
  CHECK(verdicts(R"~(
  scalar a, b, c
  assume a == b
  assume b == c
  prove one: b == c
)~") == "one PROVED uses assumption 2\n");
}

TEST_CASE("an assumption about functions holds inside the range of its parameter only") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar x
  scalar f(u) : C^2
  assume zero: f(u) == 0
  prove at: f(1/3) == 0
  prove ends: f(0) + f(1) == 0
  prove slope: f'(1/2) == 0
  prove bent: f''(u) == 0
  prove square: f(u^2) == 0
  prove reversed: f(1 - u) == 0
  prove half: f(u/2 + 1/4) == 0
  prove outside: f(2) == 0
  prove before: f(-1/100) == 0
  prove wider: f(2*u) == 0
  prove anywhere: f(x) == 0
)~") == R"~(at PROVED uses zero
ends PROVED uses zero
slope PROVED uses zero
bent PROVED uses zero
square PROVED uses zero
reversed PROVED uses zero
half PROVED uses zero
outside UNKNOWN (an assumption about a function is known only for parameters in their range)
before UNKNOWN (an assumption about a function is known only for parameters in their range)
wider UNKNOWN (an assumption about a function is known only for parameters in their range)
anywhere UNKNOWN (an assumption about a function is known only for parameters in their range)
)~");
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar x
  scalar f(t)
  assume zero: f(u) == 0
  assume low: x >= 0
  assume high: x <= 1/2
  prove inside: f(x) == 0
  prove twice: f(2*x) == 0
  prove thrice: f(3*x) == 0
)~") == R"~(inside PROVED uses zero uses low uses high
twice PROVED uses zero uses low uses high
thrice UNKNOWN (an assumption about a function is known only for parameters in their range)
)~");
}

TEST_CASE("a function defined by others brings its derivatives along") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar f(u), g(u) : C^2
  assume partition: f(u) + g(u) == 1
  prove value: g(1/2) == 1 - f(1/2)
  prove slope: f'(u) + g'(u) == 0
  prove bent: g''(0) == -f''(0)
  refute too_much: f'(u) == 0
)~") == R"~(value PROVED uses partition
slope PROVED uses partition
bent PROVED uses partition
too_much REFUTED
)~");
}

TEST_CASE("an equation in a parameter speaks of each of its powers") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar a, b, c
  assume zero: a*u^2 + b*u + c == 0
  prove first: a == 0
  prove all: a + b + c == 0
)~") == "first PROVED uses zero\nall PROVED uses zero\n");
  // On an interval that may be a single point, it does not.
  CHECK(verdict("scalar s, t, a\nparam u in [s, t]\nassume zero: a*u == 0", "a == 0") == "UNKNOWN");
}

TEST_CASE(
    "equations that are not linear are used as they stand, and named when that is too little") {
  CHECK(verdicts(R"~(
  scalar x
  assume square: x^2 == 4
  prove same: x^2 == 4
  prove multiple: x^3 == 4*x
  prove other: x == x
  refute root: x == 3
)~") == R"~(same PROVED uses square
multiple PROVED uses square
other PROVED
root REFUTED
)~");
  CHECK(
      verdicts(R"~(
  scalar x
  assume square: x^2 == 2
  prove same: x^4 == 4
)~") ==
      "same UNKNOWN (no values are known for which all assumptions and conditions hold: no example "
      "was found)\n");
}

TEST_CASE("assumptions that contradict each other prove nothing") {
  const std::vector<std::string> declarations{
      "scalar a\nassume one: a == 1\nassume two: a == 2",
      "scalar a, b\nassume one: a < b\nassume two: b < a",
      "scalar a, b\nassume one: a == b\nassume two: a != b",
      "scalar a, b, c\nassume one: a <= b\nassume two: b <= c\nassume three: c < a",
      "scalar a\nassume one: 0 == 1",
      "scalar a\nassume one: 2 < 1",
      "scalar a\nassume one: a > 0\nassume two: a == -1",
      "scalar a\nassume one: a >= 0\nassume two: a <= 0\nassume three: a != 0",
      "param u in [0, 1]\nassume one: u == 1/2",
      "param u in [0, 1]\nassume one: u >= 2",
      "param u in [0, 1]\nscalar a\nassume one: a*u == 1",
      "param u in [0, 1]\nscalar f(u)\nassume one: f(u) == u\nassume two: f(0) == 1",
      "param u in [0, 1]\nscalar f(u) : C^1\nassume one: f(u) == u\nassume two: f'(0) == 0",
      "param u in [0, 1]\nscalar f(u)\nassume one: f(u) == 0\nassume two: f(u) == 1",
      "point P in R^2\nassume one: P == (0, 0)\nassume two: P.x == 1",
      "point P, Q\nassume one: P == Q\nassume two: P != Q",
  };
  for (const std::string& text : declarations) {
    INFO(text);
    CHECK(verdict(text, "1 == 1") == "VACUOUS");
    CHECK(verdict(text, "1 == 2") == "VACUOUS");
  }
}

TEST_CASE("assumptions that contradict each other in a way not seen prove nothing either") {
  const std::vector<std::string> declarations{
      "scalar x\nassume one: x^2 == -1",
      "scalar x\nassume one: x^2 < 0",
      "scalar x, y\nassume one: x*y == 1\nassume two: x == 0",
      "scalar x, y\nassume one: x^2 + y^2 == 0\nassume two: x == 1",
      "scalar x\nassume one: exp(x) == 0",
      "scalar x\nassume one: sin(x) == 2",
      "param u in [0, 1]\nscalar f(u)\nassume one: f(0) == 1\nassume two: f(u) == u",
      "param u in [0, 1]\nscalar f(t) : C^1\nassume one: f(0) == f(1)\nassume two: f'(u) == 1",
      "param u in [0, 1]\nscalar a\nassume one: u < a\nassume two: a <= 0",
  };
  for (const std::string& text : declarations) {
    INFO(text);
    const std::string found = verdict(text, "1 == 1");
    CHECK((found == "VACUOUS" || found == "UNKNOWN"));
    const std::string wrong = verdict(text, "1 == 2");
    CHECK((wrong == "VACUOUS" || wrong == "UNKNOWN"));
  }
}

}  // namespace patchproof
