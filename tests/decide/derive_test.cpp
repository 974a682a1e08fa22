#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

TEST_CASE("unknowns are solved for, and compared with what they are said to be") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar x, y, a, b
  derive sum_and_difference: x, y from x + y == a, x - y == b gives (a+b)/2, (a-b)/2
  derive wrong: x, y from x + y == a, x - y == b gives (a-b)/2, (a+b)/2
  derive silent: x from 3*x == a
  derive by_parameter: x, y from x*u + y == a*u + b gives a, b
  derive by_square: x from x*u^2 == a*u*u gives a
)~") == R"~(sum_and_difference PROVED
wrong REFUTED
silent PROVED
by_parameter PROVED
by_square PROVED
)~");
}

TEST_CASE("dividing by a symbol makes a condition of the solution") {
  CHECK(verdicts(R"~(
  scalar x, y, a, b, c
  derive one: x from a*x == b gives b/a
  derive same: x from a*x == a gives 1
  derive cramer: x, y from a*x + b*y == 1, b*x - a*y == 0
)~") == R"~(one PROVED IF {a != 0}
same PROVED IF {a != 0}
cramer PROVED IF {a != 0} {a^2 + b^2 != 0}
)~");
  CHECK(verdicts(R"~(
  scalar x, a
  assume regular: a != 0
  derive same: x from a*x == a gives 1
  derive wrong: x from a*x == a + 1 gives 1
)~") == "same PROVED\nwrong REFUTED\n");
}

TEST_CASE("what the equations leave open is said, unless it was meant") {
  CHECK(verdicts(R"~(
  scalar x, y, z, a
  derive open: x, y from x + y == a
  derive meant: x, y from x + y == a leaves y
  derive other: x, y from x + y == a leaves x
  derive too_free: x, y, z from x + y == a leaves z
  derive too_much: x, y from x + y == a, x - y == a leaves y
  derive nothing: x from a == a
  derive useless: x from 0*x == 0 leaves x
)~") == R"~(open UNDERDETERMINED free y
meant PROVED free y
other PROVED free x
too_free UNDERDETERMINED free y free z
too_much UNDERDETERMINED
nothing UNDERDETERMINED free x
useless PROVED free x
)~");
}

TEST_CASE("equations without a solution are inconsistent") {
  CHECK(verdicts(R"~(
  param u in [0, 1]
  scalar x, y
  derive two: x from x == 1, x == 2
  derive meant: x from x == 1, x == 2 inconsistent
  derive three: x, y from x + y == 1, x - y == 1, x == 2
  derive by_parameter: x from x == u
  derive not_meant: x from x == 1 inconsistent
)~") == R"~(two INCONSISTENT (the equations lead to 0 == 1)
meant INCONSISTENT (the equations lead to 0 == 1)
three INCONSISTENT (the equations lead to 0 == 1)
by_parameter INCONSISTENT (the equations lead to 0 == 1)
not_meant PROVED
)~");
}

TEST_CASE("equations that are not linear in the unknowns are not solved") {
  CHECK(verdicts(R"~(
  scalar x, y
  scalar f(t)
  derive square: x from x^2 == 1
  derive product: x, y from x*y == 1
  derive angle: x from sin(x) == 1
  derive place: x from f(x) == 1
)~") == R"~(square UNKNOWN (the equations are not linear in the unknowns)
product UNKNOWN (the equations are not linear in the unknowns)
angle UNKNOWN (an unknown occurs in the argument of a function)
place UNKNOWN (an unknown occurs in the argument of a function)
)~");
}

TEST_CASE("assumptions about the unknowns are equations for them as well") {
  CHECK(verdicts(R"~(
  scalar x, y, a
  assume both: x + y == a
  derive x_and_y: x, y from x == y gives a/2, a/2
)~") == "x_and_y PROVED\n");
  CHECK(verdicts(R"~(
  scalar a, x
  assume zero: a == 0
  derive lost: x from a*x == a gives 1
  derive open: x from a*x == a leaves x
)~") == "lost UNDERDETERMINED free x\nopen PROVED free x\n");
}

TEST_CASE("points are solved for coordinate by coordinate, or as a whole") {
  CHECK(verdicts(R"~(
  param t in [0, 1]
  point P, A, B
  point Q in R^2
  derive middle: P from P - A == B - P gives (A + B)/2
  derive bezier_twist: P from 3*(P - A) == B gives A + B/3
  derive plane: Q from Q.x + Q.y == 3, Q.x - Q.y == 1 gives (2, 1)
  derive half: Q from Q.x == 1
)~") == R"~(middle PROVED
bezier_twist PROVED
plane PROVED
half UNDERDETERMINED free Q.y
)~");
}

TEST_CASE("what was derived can be used by later claims, with its conditions") {
  CHECK(verdicts(R"~(
  scalar x, y, a, b
  derive found: x from a*x == b gives b/a
  prove built: a*x == b using found
  prove without: a*x == b
  prove other: x + x == 2*x using found
  derive next: y from y == a*x using found gives b
  prove both: y == b using found, next
  derive failed: y from y == 1, y == 2
  prove on_failed: y == 1 using failed
  derive wrong: y from y == 1 gives 2
  prove on_wrong: y == 1 using wrong
)~") == R"~(found PROVED IF {a != 0}
built PROVED IF {a != 0}
without REFUTED
other PROVED IF {a != 0}
next PROVED IF {a != 0}
both PROVED IF {a != 0}
failed INCONSISTENT (the equations lead to 0 == 1)
on_failed UNKNOWN (it uses 'failed', which is not derived)
wrong REFUTED
on_wrong UNKNOWN (it uses 'wrong', which is not derived)
)~");
}

TEST_CASE("holes of a matrix are what is not given") {
  CHECK(verdicts(R"~(
  param t in [0, 1]
  matrix M = [?, (1, 1), (2, 0), ?]
  curve C(t) = bezier(M)
  derive ends: M from C(0) == (0, 0), C(1) == (3, 0) gives [(0, 0), (1, 1), (2, 0), (3, 0)]
  prove straight: C'(0) == (3, 3) using ends
  refute bent: C'(0) == (3, 3)
)~") == "ends PROVED\nstraight PROVED\nbent REFUTED\n");
}

TEST_CASE("a solvable system is never said to be inconsistent, whatever its coefficients") {
  // x = 1 or 1/2 solves each of them; the coefficients are related in ways the kernel cannot see.
  const std::vector<std::string> systems{
      "x*sqrt(u^2) == u",
      "x*sqrt(u)*sqrt(v) == sqrt(u*v)",
      "x*sqrt(u^2 + 2*u + 1) == u + 1",
      "x == 1, 2*x*(cos(pi/5) - cos(2*pi/5)) == 1",
      "x == 1/2, x == cos(pi/5) - cos(2*pi/5)",
      "x*(sqrt(2) - 1) == sqrt(3 - 2*sqrt(2))",
      "x*exp(u)*exp(v) == exp(u + v)",
      "x*sin(u)*cos(u)*2 == sin(2*u)",
      "x*sqrt(2)*sqrt(3) == sqrt(6)",
      "x*f(u) == f(u)",
  };
  for (const std::string& system : systems) {
    INFO(system);
    const std::string lines =
        verdicts("param u, v in [0, 1]\nscalar x\nscalar f(u)\nderive d: x from " + system + "\n");
    CHECK(lines.find("INCONSISTENT") == std::string::npos);
    CHECK(lines.find("ERROR") == std::string::npos);
    CHECK(lines.find("INTERNAL") == std::string::npos);
  }
}

TEST_CASE("a solution that is not always the only one is not said to be") {
  // f may be zero everywhere, and [a, b] may be the point 0: then every x is a solution.
  const std::string of_function =
      verdicts("param u in [0, 1]\nscalar x\nscalar f(u)\nderive d: x from x*f(u) == f(u)\n");
  CHECK(of_function.rfind("d UNKNOWN", 0) == 0);
  const std::string of_point =
      verdicts("scalar a, b, x\nparam u in [a, b]\nderive d: x from x*u == u\n");
  CHECK(of_point.rfind("d UNKNOWN", 0) == 0);
}

TEST_CASE("a system that is solvable for special data only is not inconsistent") {
  const std::string lines = verdicts(
      "scalar x, a, b\nderive d: x from x == a, x == b gives a\n"
      "derive e: x from x == a, x == a + 1\n");
  CHECK(lines.rfind("d UNKNOWN", 0) == 0);
  CHECK(lines.find("\ne INCONSISTENT") != std::string::npos);
}

}  // namespace patchproof
