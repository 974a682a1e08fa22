#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

TEST_CASE("a divisor that cancels leaves its condition") {
  CHECK(verdicts(R"~(
  scalar x, y
  prove self: x/x == 1
  prove binomial: (x^2 - 1)/(x - 1) == x + 1
  prove inverse: x^-2*x^2 == 1
  prove zeroth: (x/x)^0 == 1
  prove twice: x/x + y/y == 2
  prove product: (x*y)/(x*y) == 1
  prove inside: 1/(1/x) == x
  prove shifted: (x - y)/(y - x) == -1
  prove number: (2*x)/2 == x
  prove unused: 0*(1/x) == 0
)~") == R"~(self PROVED IF {x != 0}
binomial PROVED IF {x - 1 != 0}
inverse PROVED IF {x != 0}
zeroth PROVED IF {x != 0}
twice PROVED IF {x != 0} {y != 0}
product PROVED IF {x*y != 0}
inside PROVED IF {x != 0}
shifted PROVED IF {x - y != 0}
number PROVED
unused PROVED IF {x != 0}
)~");
}

TEST_CASE("a condition that ranges and assumptions cover is not left") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar a, b
  assume order: a < b
  prove above: (1 + u)/(1 + u) == 1
  prove below: (u - 2)/(u - 2) == 1
  prove at_the_end: u/u == 1
  prove span: (b - a)/(b - a) == 1
  prove sum: (a + b)/(a + b) == 1
  prove squares: (a^2 + 1)/(a^2 + 1) == 1
)~") == R"~(above PROVED
below PROVED
at_the_end PROVED IF {u != 0}
span PROVED uses order
sum PROVED IF {a + b != 0}
squares PROVED
)~");
  CHECK(verdicts(R"~(
  scalar x, y
  assume nonzero: x != 0
  prove same: x/x == 1
  prove powers: x^3/x^3 == 1
  prove with_other: (x*y)/(x*y) == 1
  prove other: y/y == 1
)~") == R"~(same PROVED uses nonzero
powers PROVED uses nonzero
with_other PROVED IF {x*y != 0}
other PROVED IF {y != 0}
)~");
}

TEST_CASE("the condition of a function comes along wherever the function is used") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar x
  let f(t) = t^2/t
  prove at: f(x) == x
  prove inside: f(u + 1) == u + 1
  prove slope: f'(x) == 1
  prove at_zero: f(0) == 0
  prove slope_at_zero: f'(0) == 1
  prove composed: f(f(x)) == x
)~") == R"~(at PROVED IF {x != 0}
inside PROVED
slope PROVED IF {x != 0}
at_zero ERROR (division by zero)
slope_at_zero ERROR (division by zero)
composed PROVED IF {x != 0}
)~");
}

TEST_CASE("roots need radicands that are not negative") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar x
  prove square: sqrt(x)^2 == x
  prove inside: sqrt(u)^2 == u
  prove shifted: sqrt(1 - u)^2 == 1 - u
  prove even: sqrt(x^2 + 1)^2 == x^2 + 1
  prove slope: diff(sqrt(x), x)*2*sqrt(x) == 1
  prove slope_inside: diff(sqrt(1 + u), u)*2*sqrt(1 + u) == 1
  prove slope_at_end: diff(sqrt(u), u)*2*sqrt(u) == 1
  prove negative: sqrt(-4) == 2
)~") == R"~(square PROVED IF {x >= 0}
inside PROVED
shifted PROVED
even PROVED
slope PROVED IF {x != 0} {x >= 0}
slope_inside PROVED
slope_at_end PROVED IF {u != 0}
negative ERROR (the square root of a negative number)
)~");
}

TEST_CASE("a statement that nowhere has a value is an error") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar x, y
  curve C(u) : C^1
  prove zero: 1/(x - x) == 1/(x - x)
  prove hidden: x/((x + 1)^2 - x^2 - 2*x - 1) == 0
  prove trigonometric: 1/(sin(x)^2 + cos(x)^2 - 1) == 0
  prove root: sqrt(2)/(sqrt(2)*sqrt(3) - sqrt(6)) == 1
  prove too_smooth: C''(u) == C''(u)
  prove too_smooth_inside: diff(C(u)*u, u, 2) == C''(u)*u + 2*C'(u)
  prove known: C'(u) == C'(u)
)~") == R"~(zero ERROR (division by zero)
hidden ERROR (division by zero)
trigonometric ERROR (division by zero)
root ERROR (division by zero)
too_smooth ERROR (a derivative of order 2 of 'C', which is only assumed C^1)
too_smooth_inside ERROR (a derivative of order 2 of 'C', which is only assumed C^1)
known PROVED
)~");
  CHECK(verdicts(R"~(
  scalar x, y
  assume same: x == y
  prove gone: 1/(x - y) == 1/(x - y)
)~") == "gone ERROR (division by zero)\n");
}

TEST_CASE("the order of derivatives is counted over all parameters of a patch") {
  CHECK(verdicts(R"~(
  param u, v in [0, 1]
  patch r(u, v) : C^2
  curve C(u), D(u) : C^2
  prove second: r_uv(u, v) == r_vu(u, v)
  prove third: r_uuv(u, v) == r_uvu(u, v)
  prove along: diff(ruled(C, D), u, 2, v, 1)(u, v) == D''(u) - C''(u)
)~") == R"~(second PROVED
third ERROR (a derivative of order 3 of 'r', which is only assumed C^2)
along PROVED
)~");
}

TEST_CASE("knot differences of symbols become conditions, or are assumed") {
  const std::string patch = R"~(
  param u in [0, 1]
  curve C1(u), C2(u)
  scalar a, b
  param w in [a, b]
)~";
  CHECK(verdicts(patch + R"~(
  prove start: ruled_over(C1, C2, a, b)(u, a) == C1(u)
  prove end_: ruled_over(C1, C2, a, b)(u, b) == C2(u)
  refute swapped: ruled_over(C1, C2, a, b)(u, b) == C1(u)
)~") == R"~(start PROVED IF {a - b != 0}
end_ PROVED IF {a - b != 0}
swapped REFUTED
)~");
  CHECK(verdicts(patch + R"~(
  assume order: a < b
  prove start: ruled_over(C1, C2, a, b)(u, a) == C1(u)
)~") == "start PROVED uses order\n");
}

TEST_CASE("conditions on numbers are decided, not left open") {
  CHECK(verdict("", "pi/pi == 1") == "PROVED");
  CHECK(verdict("", "(pi - 3)/(pi - 3) == 1") == "PROVED");
  CHECK(verdict("", "sqrt(pi - 3)^2 == pi - 3") == "PROVED");
  CHECK(verdict("", "sqrt(1 - pi) == sqrt(1 - pi)") == "ERROR");
  CHECK(verdict("", "1/(sqrt(2) - 7/5) == 1/(sqrt(2) - 7/5)") == "PROVED");
  // A divisor that is zero in a way the kernel cannot see.
  const std::string zero = "(sqrt(3 - 2*sqrt(2)) - sqrt(2) + 1)";
  CHECK(verdict("", zero + "/" + zero + " == 1") == "UNKNOWN");
  CHECK(verdict("", "1/" + zero + " == 1/" + zero) == "UNKNOWN");
}

TEST_CASE("a condition on a parameter that the claim does not name is one on all its values") {
  CHECK(verdicts_of(R"(
case c
  param t in [0, 1]
  scalar a, x, y
  assume given: y == x/(a - t)
  prove named: y*(a - t) == x
  prove value: y*(a - 1/2) == x
end
)") ==
        "named PROVED IF {a - t != 0} uses given\n"
        "value PROVED IF {a - t != 0 for all t} uses given\n");
}

}  // namespace patchproof
