#include <catch2/catch.hpp>

#include <tests/decide/verdicts.hpp>

// Each of these once made the program answer what it must not: found by people who tried to break
// it.

namespace patchproof {

TEST_CASE("a scalar argument that contains u is not captured by a definition's own u") {
  CHECK(verdicts_of(R"(
define scaled(C : curve(u), k : scalar) : patch(u, v)
  = ruled(k*C(u), C(u))
end
case capture
  param u, v in [0, 1]
  curve C(u) : C^0
  patch r(u, v) = scaled(C, v)
  prove kept: scaled(C, u)(0,0) == u*C(0)
  refute lost: scaled(C, u)(0,0) == 0
  refute taken: scaled(C, u)(1/2,0) == 1/2*C(1/2)
end
)") == "kept PROVED\nlost REFUTED\ntaken REFUTED\n");
}

TEST_CASE("a definition speaks of the parameters of its arguments by its own names") {
  CHECK(verdicts_of(R"(
define first_derivative(r : patch(u, v)) : patch(u, v)
  = r_u(u, v)
end
define itself(C : curve(u)) : patch(u, v)
  = C + 0*v*C(0)
end
case c
  param u, v in [0, 1]
  patch p(v, u) = (v^2, u^3)
  curve B(v) = (v, v^2)
  prove first: first_derivative(p)(u, v) == (2*u, 0)
  refute by_name: first_derivative(p)(u, v) == (0, 3*v^2)
  prove at_u: itself(B)(u, v) == (u, u^2)
  refute at_v: itself(B)(u, v) == (v, v^2)
end
)") == "first PROVED\nby_name REFUTED\nat_u PROVED\nat_v REFUTED\n");
}

TEST_CASE("unknown functions and roots of parameters are not independent of each other") {
  const std::string reason =
      "(the equations hold for all parameters, and contain functions of them that may depend on "
      "each "
      "other)\n";
  CHECK(verdicts_of(R"(
case d
  param u, v in [0, 1]
  scalar f(t), g(t), x, y
  derive a: x from x*f(u) == f(u) gives 1
  derive b: x, y from x*f(u) + y*g(u) == 0 gives 0, 0
  derive c: x, y from x*sqrt(u^2) + y*u == 0 gives 0, 0
  derive d: x from x*f(u) == g(u) inconsistent
  derive e: x, y from x*sin(u) + y*cos(2*u) == 3*sin(u) gives 3, 0
end
)") == "a UNKNOWN " + reason + "b UNKNOWN " + reason + "c UNKNOWN " + reason + "d UNKNOWN " +
            reason + "e PROVED\n");
}

TEST_CASE("an equation on an interval that may be a point says nothing of coefficients") {
  CHECK(verdicts_of(R"(
case r
  scalar a, b, x, y
  param t in [a, b]
  scalar f(t) : C^1
  derive c: x, y from x*t + y == 0 gives 0, 0
  assume zero: f(t) == 0
  prove slope: f'(a) == 0
end
)") == "c UNKNOWN (the range of 't' may be a single point; assume that its ends differ)\n"
       "slope UNKNOWN (the range of 't' may be a single point; assume that its ends differ)\n");
  CHECK(verdicts_of(R"(
case r
  scalar a, b, x, y
  param t in [a, b]
  assume proper: a < b
  derive c: x, y from x*t + y == 0 gives 0, 0
end
)") == "c PROVED\n");
}

TEST_CASE("a parameter that an inequality restricts determines nothing") {
  CHECK(verdicts_of(R"(
case r
  param u in [0, 1]
  scalar x, y
  assume low: u <= 0
  derive a: x, y from x*u + y == 0 gives u - u, 0
end
)") == "a UNKNOWN (an inequality restricts 'u', so it is not clear for how many of its values the "
       "equations hold)\n");
}

TEST_CASE("an unknown is not its own value") {
  CHECK(verdicts_of(R"(
case t
  scalar x, y
  derive a: x from x == 5 gives x
  derive b: x from x == 5 gives 5 + y*x - x*y
  derive c: x, y from x == y gives y, y leaves y
end
)") == "a UNKNOWN (the value given contains the unknown 'x', so there is nothing to compare)\n"
       "b PROVED\nc PROVED free y\n");
}

TEST_CASE("points of any dimension are not divided by") {
  const std::string reason =
      "(an unknown number times a point of any dimension: declare the dimension, 'in R^3')\n";
  CHECK(verdicts_of(R"(
case d
  point P, Q
  scalar x, y
  derive a: x from x*P == Q
  derive b: x, y from x*P + y*Q == P leaves y
end
)") == "a UNKNOWN " + reason + "b UNKNOWN " + reason);
}

TEST_CASE("no solution means none for any data") {
  CHECK(verdicts_of(R"(
case d
  scalar a, b, x
  derive e: x from x == a, x == b inconsistent
  derive f: x from x == 1, x == 2 inconsistent
end
case with_assumption
  scalar a, b, x
  assume apart: a != b
  derive e: x from x == a, x == b inconsistent
end
)") == "e UNKNOWN (there is a solution only where -a + b == 0)\n"
       "f INCONSISTENT (the equations lead to 0 == 1)\n"
       "e INCONSISTENT (the equations lead to 0 == -a + b)\n");
}

TEST_CASE("derivations that contradict or define each other prove nothing") {
  CHECK(verdicts_of(R"(
case d
  scalar x
  derive A: x from x == 1
  derive B: x from x == 2
  prove one: x == 1 using A, B
  prove two: x == 2 using B, A
end
case cycle
  scalar x, y
  derive A: x from x == y
  derive B: y from y == x
  prove c: x == y using A, B
end
)") == "A PROVED\nB PROVED\none VACUOUS\ntwo VACUOUS\n"
       "A PROVED\nB PROVED\n"
       "c UNKNOWN (the derivations used define 'x' by itself)\n");
}

TEST_CASE("a point with one coordinate fixed is not arbitrary") {
  CHECK(verdicts_of(R"(
case d
  point P, Q in R^2
  derive E: P from P.x == Q.x leaves P
  derive F: P from P.x == Q.x, P.y == 0 gives (Q.x, 0)
end
)") == "E UNDERDETERMINED free P.y\nF PROVED\n");
}

TEST_CASE("a condition that fails for all values is no condition") {
  CHECK(verdicts_of(R"(
case c
  scalar a
  param u in [0, 1]
  prove root: sqrt(3+2*sqrt(2)) - 1 - sqrt(2) == 0
  prove hidden: 1 == a/(sqrt(3+2*sqrt(2)) - 1 - sqrt(2))*(sqrt(3+2*sqrt(2)) - 1 - sqrt(2))/a
  prove range: sqrt(u-2)^2 == u - 2
end
)")
            .find("PROVED") == std::string::npos);
}

TEST_CASE("inequalities between numbers are settled by enclosures") {
  CHECK(verdicts_of(R"(
case c
  prove root: sqrt(2) > 1
  prove pi: pi != 22/7
  refute pi_large: pi >= 22/7
  prove points: (1, 2) != (1, 3)
  prove points_too: (1, 2) != (0, 2)
  refute same: (1, 2) != (1, 2)
end
)") == "root PROVED\npi PROVED\npi_large REFUTED\npoints PROVED\npoints_too PROVED\nsame REFUTED\n");
}

TEST_CASE("nested functions end within the limits") {
  std::string text = "case a\n  scalar x\n  let k0 = x + 1\n";
  for (int k = 1; k <= 40; ++k)
    text += "  let k" + std::to_string(k) + " = sin(k" + std::to_string(k - 1) + ")\n";
  text += "  prove p: k40 == k39\nend\n";
  Limits limits;
  limits.steps = 20'000'000;
  CHECK(verdicts_of(text, limits).rfind("p ", 0) == 0);
}

TEST_CASE("the variables of two integrals over one range stay apart") {
  CHECK(verdicts_of(R"(
case c
  param u, v in [0, 1]
  scalar z(u, v) : C^0
  scalar f(u) : C^0
  assume f(u) == integral(z(u,v), v in [0, 1])
  prove diagonal: integral(f(u), u in [0, 1]) == integral(z(u,u), u in [0, 1])
  prove square: integral(f(u)^2, u in [0, 1]) == integral(z(u,u), u in [0, 1])^2
end
)")
            .find("PROVED") == std::string::npos);
  // The value is 1/6.
  CHECK(verdicts_of(R"(
case c
  param u, v in [0, 1]
  scalar z(u, v) : C^0
  scalar f(u) : C^0
  assume f(u) == integral(z(u,v), v in [0, 1])
  assume z(u,v) == (u - v)^2
  prove wrong: integral(f(u), u in [0, 1]) == 0
end
)")
            .find("wrong PROVED") == std::string::npos);
}

TEST_CASE("what is known for v in [0, u] is not known above the diagonal") {
  // w = max(0, v - u) satisfies the assumption.
  CHECK(verdicts_of(R"(
case c
  param u in [0, 1], v in [0, u]
  scalar w(u, v) : C^0
  assume w(u,v) == 0
  prove edge: w(0,u) == 0
  prove mirrored: w(v,u) == 0
  prove line: integral(w(0,v), v in [0, u]) == 0
end
)")
            .find("PROVED") == std::string::npos);
  CHECK(verdicts_of(R"(
case c
  param u in [0, 1], v in [0, u]
  scalar w(u, v) : C^0
  assume w(u,v) == 0
  prove itself: w(u,v) == 0
  prove diagonal: w(u,u) == 0
end
)") == "itself PROVED uses assumption 1\ndiagonal PROVED uses assumption 1\n");
}

TEST_CASE("an equation holds only where the assumed inequalities do") {
  Limits limits;
  limits.steps = 200'000;
  const std::string answers = verdicts_of(R"(
case c
  param u, v in [0, 1]
  scalar w(u, v) : C^1
  assume u + v <= 1, w(u,v) == 0
  prove corner: w(1,1) == 0
  prove all: integral(w(u,v), u in [0, 1], v in [0, 1]) == 0
end
case d
  param u in [0, 1]
  scalar f(u) : C^0
  assume u <= 1/2, f(u) == 0
  prove end: f(1) == 0
end
)",
                                          limits);
  CHECK(answers.find("PROVED") == std::string::npos);
}

TEST_CASE("a function known on a diagonal only may have any derivatives there") {
  CHECK(verdicts_of(R"(
case c
  param u in [0, 1], v in [u, u]
  scalar w(u, v) : C^1
  assume w(u,v) == u
  prove along: w_u(u,v) == 1
  prove itself: w(u,v) == u
end
case d
  scalar a
  param u in [0, 1], v in [u, a*u]
  scalar w(u, v) : C^1
  assume w(u,v) == u
  prove along: w_u(u,v) == 1
end
case e
  param u in [0, 1], v in [0, u]
  scalar w(u, v) : C^2
  assume w(u,v) == u*v
  prove along: w_u(u,v) == v
  prove across: w_v(u,v) == u
end
)") ==
        "along UNKNOWN (the range of 'v' may be a single point; assume that its ends differ)\n"
        "itself PROVED uses assumption 1\n"
        "along UNKNOWN (the range of 'v' may be a single point; assume that its ends differ)\n"
        "along PROVED uses assumption 1\nacross PROVED uses assumption 1\n");
}

}  // namespace patchproof
