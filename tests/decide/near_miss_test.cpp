#include <catch2/catch.hpp>

#include "decide/verdicts.hpp"

namespace patchproof {

namespace {

// True statements, and beside each of them false ones that look almost the same.
struct Pair {
  std::string declarations;
  std::string holds;
  std::vector<std::string> false_ones;
};

const std::vector<Pair> pairs{
    {"scalar x, y",
     "(x+y)^2 == x^2 + 2*x*y + y^2",
     {"(x+y)^2 == x^2 + x*y + y^2", "(x+y)^2 == x^2 + y^2"}},
    {"scalar x", "(x-1)*(x+1) == x^2 - 1", {"(x-1)*(x+1) == x^2 + 1", "(x-1)^2 == x^2 - 1"}},
    {"scalar x, y, z", "x*y*z == z*y*x", {"x*y*z == z*y*x + 1/1000000", "x*y == y*z"}},
    // A polynomial with many roots is not zero.
    {"param u in [0, 1]",
     "u*(u-1) - u^2 + u == 0",
     {"u*(u-1)*(u-1/2) == 0", "u*(u-1)*(2*u-1)*(3*u-1)*(3*u-2)*(4*u-1)*(4*u-3)*(5*u-1) == 0"}},
    // Parameters keep to their ranges.
    {"param u in [0, 1]",
     "u*(1-u) >= 0",
     {"u*(1-u) > 0", "u*(1-u) <= 1/5", "u*(1-u) < 1/4", "u*(1-u) >= 1/100"}},
    {"param u in [0, 1]", "u <= 1", {"u < 1", "u <= 99/100", "2*u <= 1", "u >= 1/100"}},
    {"param u in [1, 2]", "u > 0", {"u > 1", "u >= 101/100", "u < 2"}},
    {"param u, v in [0, 1]", "u + v <= 2", {"u + v < 2", "u + v <= 1", "u - v >= 0", "u*v > 0"}},
    {"param u in [0, 1]", "1 + u != 0", {"u != 0", "1 - u != 0", "2*u - 1 != 0"}},
    {"scalar x", "x^2 >= 0", {"x^2 > 0", "x^3 >= 0", "x^2 >= x", "x >= 0"}},
    {"scalar x", "x^2 + 1 > 0", {"x^2 - 1 > 0", "x^2 + x > 0"}},
    {"scalar a, b\nassume o: a < b",
     "b - a > 0",
     {"b - a > 1", "b > 0", "a^2 < b^2", "2*b - a > 0"}},
    {"scalar a, b\nassume o: a <= b", "b - a >= 0", {"b - a > 0", "a != b", "a == b"}},
    {"scalar a, b\nassume o: a != b", "a - b != 0", {"a + b != 0", "a != 0", "a < b", "a == -b"}},
    {"scalar a, b, c\nassume o: a < b, b < c", "a < c", {"c - a > 2", "a + c < 2*b", "c < a"}},
    // Linear assumptions, and only what follows from them.
    {"scalar a, b, c\nassume s: a + b + c == 1",
     "c == 1 - a - b",
     {"c == 1 - a", "a == b", "a + b == 1"}},
    {"scalar a, b\nassume s: 2*a == 3*b",
     "4*a^2 == 9*b^2",
     {"2*a^2 == 3*b^2", "a == b", "3*a == 2*b"}},
    {"scalar x, y\nassume z: x*y == 0", "x^2*y == 0", {"x == 0", "x + y == 0", "x^2 == 0"}},
    {"scalar x\nassume s: x^2 == 4", "x^4 == 16 + x^2*(x^2 - 4)", {"x == 2", "x^3 == 8"}},
    // Points of every dimension.
    {"point A, B", "A + B == B + A", {"A - B == B - A", "A == B", "2*A == A"}},
    {"point A, B in R^3",
     "cross(A, B) == -cross(B, A)",
     {"cross(A, B) == cross(B, A)", "dot(A, B) == 0"}},
    {"point A, B in R^3",
     "dot(A, cross(A, B)) == 0",
     {"dot(A, cross(B, B) + B) == 0", "A.x == A.y"}},
    {"point A, B in R^2",
     "det(A, B) == A.x*B.y - A.y*B.x",
     {"det(A, B) == A.x*B.y + A.y*B.x", "det(A, B) == det(B, A)"}},
    {"scalar a, b, c, d\nmatrix A = [a, b ; c, d]\nmatrix B = [1, 2 ; 3, 4]",
     "transpose(A*B) == transpose(B)*transpose(A)",
     {"transpose(A*B) == transpose(A)*transpose(B)", "A*B == B*A", "det(A*B) == det(A) + det(B)",
      "det(2*A) == 2*det(A)"}},
    // Unknown functions: only what holds for all of them.
    {"param u, v in [0, 1]\nscalar f(u) : C^2",
     "f(u)*f(v) == f(v)*f(u)",
     {"f(u) == f(v)", "f(u+v) == f(u) + f(v)", "f(2*u) == 2*f(u)", "f(u) == f(1-u)",
      "f'(u) == f(u)", "f(u) == f(0) + u*f'(0)", "f(u) == (1-u)*f(0) + u*f(1)", "f(u)^2 == f(u^2)",
      "f''(u) == 0"}},
    {"param u in [0, 1]\nscalar f(u), g(u) : C^1\nassume same: f(u) == g(u)",
     "f'(u) == g'(u)",
     {"f'(u) == g(u)", "f(u) == g(1-u)", "f(u) == 0"}},
    {"param u in [0, 1]\nscalar f(u), g(u) : C^1\nassume same: f(0) == g(0)",
     "2*f(0) == f(0) + g(0)",
     {"f(u) == g(u)", "f(1) == g(1)", "f'(0) == g'(0)"}},
    {"param u in [0, 1]\nscalar f(u) : C^2\nassume line: f(u) == 3*u",
     "f'(1/2) == 3",
     {"f(1/2) == 3", "f'(0) == 0", "f''(0) == 3"}},
    // Derivatives.
    {"param u in [0, 1]\ncurve C(u) : C^2",
     "diff(u*C(u), u) == C(u) + u*C'(u)",
     {"diff(u*C(u), u) == u*C'(u)", "diff(u*C(u), u) == C'(u)"}},
    {"param u in [0, 1]\nscalar f(u) : C^2",
     "diff(f(u^2), u) == 2*u*f'(u^2)",
     {"diff(f(u^2), u) == f'(u^2)", "diff(f(u^2), u) == 2*u*f'(u)"}},
    {"param u in [0, 1]\nscalar f(u) : C^2",
     "diff(f(1-u), u) == -f'(1-u)",
     {"diff(f(1-u), u) == f'(1-u)", "diff(f(1-u), u) == -f'(u)"}},
    {"param u, v in [0, 1]\npatch r(u, v) : C^2",
     "r_uv(u,v) == r_vu(u,v)",
     {"r_uu(u,v) == r_vv(u,v)", "r_u(u,v) == r_v(u,v)", "r(u,v) == r(v,u)", "r_u(0,v) == 0"}},
    // The textbook's patches.
    {"param u, v in [0, 1]\ncurve C(u), D(u) : C^1\npatch r(u,v) = ruled(C, D)",
     "r_v(u,0) == D(u) - C(u)",
     {"r_v(u,0) == C(u) - D(u)", "r(u,1) == C(u)", "r_u(u,0) == D'(u)", "r(0,0) == r(1,0)"}},
    {"param u, v in [0, 1]\npoint P[0..1, 0..1]\npatch r(u,v) = bilinear(P[0,0], P[1,0], P[0,1], "
     "P[1,1])",
     "r(1,0) == P[1,0]",
     {"r(1,0) == P[0,1]", "r_uv == 0", "r(1/2,1/2) == P[0,0]"}},
    {"param t in [0, 1]\npoint b[0..3]\ncurve B(t) = bezier(b)",
     "B'(0) == 3*(b[1] - b[0])",
     {"B'(0) == b[1] - b[0]", "B'(0) == 4*(b[1] - b[0])", "B'(1) == 3*(b[2] - b[3])",
      "B(1/2) == (b[0] + b[1] + b[2] + b[3])/4"}},
    {"param t in [0, 1]",
     "sum(bernstein(4, i, t), i in 0..4) == 1",
     {"sum(bernstein(4, i, t), i in 0..3) == 1", "sum(bernstein(4, i, t), i in 1..4) == 1"}},
    {"param t in [0, 1]",
     "bernstein(3, 1, t) == bernstein(3, 2, 1-t)",
     {"bernstein(3, 1, t) == bernstein(3, 1, 1-t)", "bernstein(3, 1, t) == t*(1-t)^2"}},
    // Angles, exponentials, roots.
    {"scalar x",
     "sin(2*x) == 2*sin(x)*cos(x)",
     {"sin(2*x) == 2*sin(x)", "sin(2*x) == sin(x)*cos(x)", "sin(x)^2 == (1 + cos(2*x))/2"}},
    {"scalar x",
     "sin(x + pi/2) == cos(x)",
     {"sin(x - pi/2) == cos(x)", "sin(x) == cos(x)", "sin(x) == sin(x + pi)"}},
    {"scalar x", "sin(x + 2*pi) == sin(x)", {"sin(x + 22/7) == -sin(x)", "sin(x/2)*2 == sin(x)"}},
    {"",
     "cos(pi/12) == (sqrt(6) + sqrt(2))/4",
     {"cos(pi/12) == (sqrt(6) - sqrt(2))/4", "cos(pi/12) == 0.9659258262890682867"}},
    {"param u in [0, 1]",
     "sin(pi*u)^2 <= 1 + sin(pi*u)^2",
     {"sin(pi*u) == 0", "cos(pi*u) == 1 - 2*u"}},
    {"scalar x, y",
     "exp(x + y) == exp(x)*exp(y)",
     {"exp(x*y) == exp(x)*exp(y)", "exp(x)*exp(x) == exp(x^2)", "exp(x) == 1 + x"}},
    {"",
     "sqrt(2)*sqrt(3) == sqrt(6)",
     {"sqrt(2) + sqrt(3) == sqrt(5)", "sqrt(2) == 1.41421356237309504880168872420969807",
      "sqrt(2)*sqrt(3) == 2.44948974278317809819728407470589"}},
    {"",
     "sqrt(50) == 5*sqrt(2)",
     {"sqrt(50) == -5*sqrt(2)", "sqrt(50) == 7", "pi == 355/113", "exp(1) == 2.718281828459045",
      "pi^2 == 10"}},
    {"scalar x",
     "sqrt(x^2)^2 == x^2",
     {"sqrt(x^2) == x", "sqrt(x^2) == -x", "sqrt(x^2 + 1) == x + 1"}},
    {"param u in [0, 1]",
     "sqrt(1 + u)^2 == 1 + u",
     {"sqrt(1 + u) == 1 + u/2", "sqrt(1 + u) == 1 + u"}},
    // Splines.
    {"point d[0..4]\nspline T = bspline(d, degree 3, clamped uniform)\ncurve p(t) = segment(T, "
     "0)\ncurve q(t) = segment(T, 1)",
     "p''(1) == q''(0)",
     {"p(1) == q(1)", "p'(1) == -q'(0)", "p(1) == d[2]", "p'(0) == 3*(d[2] - d[0])"}},
};

}  // namespace

TEST_CASE("true statements are proved, and false ones beside them refuted") {
  for (const Pair& pair : pairs) {
    INFO(pair.declarations);
    {
      INFO(pair.holds);
      CHECK(verdict(pair.declarations, pair.holds) == "PROVED");
    }
    for (const std::string& false_one : pair.false_ones) {
      INFO(false_one);
      CHECK(verdict(pair.declarations, false_one) == "REFUTED");
    }
  }
}

TEST_CASE("false statements beyond the methods are not proved") {
  const std::vector<std::pair<std::string, std::string>> table{
      // The range of the assumption is [0, 1].
      {"param u in [0, 1]\nscalar f(u) : C^1\nassume z: f(u) == 0", "f(2) == 0"},
      {"param u in [0, 1]\nscalar f(u) : C^1\nassume z: f(u) == 0", "f(-u) == 0"},
      {"param u in [0, 1]\nscalar f(u) : C^1\nassume z: f(u) == 0", "f(2*u) == 0"},
      {"param u in [0, 1]\nscalar f(u) : C^1\nassume z: f(u) == 0", "f'(3/2) == 0"},
      {"param u in [0, 1]\nscalar x\nscalar f(u) : C^1\nassume z: f(u) == 0", "f(x) == 0"},
      {"param u in [0, 1]\nparam v in [0, 2]\nscalar f(u)\nassume z: f(u) == u", "f(v) == v"},
      {"param u in [0, 1]\nscalar a\nscalar f(t)\nassume z: f(a*u) == 0", "f(u) == 0"},
      {"param u in [0, 1]\nscalar f(t)\nassume sym: f(u) == f(1-u)", "f(0) == f(1/2)"},
      {"param u, v in [0, 1]\nscalar g(u, v)\nassume diagonal: g(u, u) == 0", "g(u, v) == 0"},
      {"param u, v in [0, 1]\nscalar g(u, v)\nassume edge: g(u, 0) == 0", "g(u, 1) == 0"},
      {"param u, v in [0, 1]\nscalar g(u, v) : C^1\nassume edge: g(u, 0) == 0", "g_v(u, 0) == 0"},
      // What is true of the square root of both is not true of the numbers.
      {"scalar x, y\nassume s: x^2 == y^2", "x == y"},
      {"scalar x\nassume s: x^2 == x", "x == 1"},
      {"scalar x, y\nassume s: x*y == x", "y == 1"},
      {"scalar x, y\nassume s: exp(x) == exp(2*y)", "x == y"},
      {"scalar x, y\nassume s: sin(x) == sin(y)", "x == y"},
      // Rational functions with signs that change.
      {"param u in [0, 1]", "1/(u - 1/2) > 0"},
      {"scalar a, b", "a/b > 0"},
      {"scalar a, b\nassume q: a*b > 0", "a > 0"},
      {"scalar a, b\nassume q: a > 0", "a/b >= 0"},
      {"scalar x", "sqrt(x)*sqrt(x) > 0"},
      {"scalar x", "sqrt(x) >= 1"},
      {"param a in [0, 1]\nscalar s, t\nparam u in [s, t]", "u >= 0"},
      {"scalar s, t\nparam u in [s, t]", "s < t"},
      {"scalar s, t\nparam u in [s, t]", "u > s"},
      // Points: a generic coordinate does not stand for a number.
      {"point P, Q, R\nassume d: P != Q", "P != R"},
      {"point P, Q in R^2\nassume d: P != Q", "P.x != Q.x"},
      {"point P, Q in R^2\nassume d: P.x != Q.x", "P.y != Q.y"},
      {"point P, Q in R^2\nassume d: P.x == Q.x", "P == Q"},
  };
  for (const auto& [declarations, statement] : table) {
    INFO(declarations << "\n" << statement);
    const std::string found = verdict(declarations, statement);
    CHECK((found == "REFUTED" || found == "UNKNOWN"));
  }
}

TEST_CASE("true statements beyond the methods are not refuted") {
  const std::vector<std::pair<std::string, std::string>> table{
      {"", "sqrt(3 - 2*sqrt(2)) == sqrt(2) - 1"},
      {"", "cos(pi/5) - cos(2*pi/5) == 1/2"},
      {"", "sin(pi/8)^2 == (2 - sqrt(2))/4"},
      {"param u in [0, 1]", "sqrt(u^2) == u"},
      {"param u in [0, 1]", "sqrt(u^2 + 2*u + 1) == u + 1"},
      {"param u, v in [0, 1]", "sqrt(u)*sqrt(v) == sqrt(u*v)"},
      {"param u in [0, 1]", "u*(1-u) <= 1/4"},
      {"scalar x, y", "x^2 + y^2 >= 2*x*y"},
      {"scalar x", "x^2 + x + 1 > 0"},
      {"scalar x", "sin(x) <= 1"},
      {"scalar x", "exp(x) > 0"},
      {"scalar x", "exp(x) != 0"},
      {"", "sqrt(2) > 1"},
      {"", "pi > 3"},
      {"", "sqrt(2) != 1"},
      {"param u in [0, 1]\nscalar f(t)\nassume sym: f(u) == f(1-u)", "f(0) == f(1)"},
      {"param u, v in [0, 1]\nscalar g(u, v)\nassume edge: g(u, 0) == 0", "g(1/2, 0) == 0"},
      {"scalar a\nscalar f(t)\nassume at: f(a) == 2\nassume one: a == 1", "f(1) == 2"},
      {"scalar x\nassume s: x^2 == 2", "x^4 == 4"},
      {"scalar x, y\nassume s: x^3 == y^3", "x == y"},
      {"param u in [0, 1]\nscalar f(u) : C^1\nassume slope: f'(u) == 0", "f(0) == f(1)"},
  };
  for (const auto& [declarations, statement] : table) {
    INFO(declarations << "\n" << statement);
    const std::string found = verdict(declarations, statement);
    CHECK((found == "PROVED" || found == "UNKNOWN"));
  }
}

}  // namespace patchproof
