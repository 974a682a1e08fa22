#include <patchproof/symbolic/second_opinion.hpp>

#include <catch2/catch.hpp>
#include <ctime>
#include <string>
#include <vector>

#include <tests/symbolic/terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

// Four unknown curves and the bilinearly blended Coons patch between them.
struct Coons {
  Declarations declare;
  Term u = declare.parameter("u");
  Term v = declare.parameter("v");
  Term C1 = declare.curve("C1", "u");
  Term C2 = declare.curve("C2", "u");
  Term D1 = declare.curve("D1", "v");
  Term D2 = declare.curve("D2", "v");
  Term zero = number(0);
  Term one = number(1);
  Term ruled_in_v = (1 - v) * at(C1, {u}) + v * at(C2, {u});
  Term ruled_in_u = (1 - u) * at(D1, {v}) + u * at(D2, {v});
  Term bilinear = (1 - u) * ((1 - v) * at(C1, {zero}) + v * at(C2, {zero})) +
                  u * ((1 - v) * at(C1, {one}) + v * at(C2, {one}));
  Term patch = lambda({u, v}, ruled_in_v + ruled_in_u - bilinear);
  std::vector<Statement> closure{
      equation(at(C1, {zero}), at(D1, {zero})), equation(at(C1, {one}), at(D2, {zero})),
      equation(at(C2, {zero}), at(D1, {one})), equation(at(C2, {one}), at(D2, {one}))};
};

}  // namespace

TEST_CASE("a Coons patch interpolates its four boundary curves if their ends meet") {
  const Coons c;
  CHECK(holds(at(c.patch, {c.u, c.zero}), at(c.C1, {c.u}), c.closure));
  CHECK(holds(at(c.patch, {c.u, c.one}), at(c.C2, {c.u}), c.closure));
  CHECK(holds(at(c.patch, {c.zero, c.v}), at(c.D1, {c.v}), c.closure));
  CHECK(holds(at(c.patch, {c.one, c.v}), at(c.D2, {c.v}), c.closure));
}

TEST_CASE("a Coons patch between curves whose ends do not meet misses them") {
  const Coons c;
  CHECK(holds(at(c.patch, {c.zero, c.v}), at(c.D1, {c.v})));
  CHECK(fails(at(c.patch, {c.u, c.zero}), at(c.C1, {c.u})));
  CHECK(difference(at(c.patch, {c.u, c.zero}), at(c.C1, {c.u})) ==
        "u*C1(0) - u*C1(1) - u*D1(0) + u*D2(0) - C1(0) + D1(0)");
  const std::vector<Statement> three{c.closure[0], c.closure[1], c.closure[2]};
  CHECK(fails(at(c.patch, {c.u, c.one}), at(c.C2, {c.u}), three));
}

TEST_CASE("a sum of two ruled patches does not interpolate") {
  const Coons c;
  const Term both = lambda({c.u, c.v}, c.ruled_in_v + c.ruled_in_u);
  CHECK(fails(at(both, {c.u, c.zero}), at(c.C1, {c.u}), c.closure));
}

TEST_CASE("a Coons patch has r_uuvv = 0, and not r_uvv = 0") {
  const Coons c;
  const Term nothing = 0 * c.bilinear;
  CHECK(holds(at(derivative(c.patch, {2, 2}), {c.u, c.v}), nothing));
  CHECK(fails(at(derivative(c.patch, {1, 2}), {c.u, c.v}), nothing));
  CHECK(difference(at(derivative(c.patch, {1, 2}), {c.u, c.v}), nothing) == "-D1''(v) + D2''(v)");
}

TEST_CASE("a Coons patch is the bordered matrix of its boundary values") {
  const Coons c;
  const auto r = [&](const Term& u, const Term& v) { return at(c.patch, {u, v}); };
  const Term left = matrix(1, 3, {1 - c.u, number(-1), c.u});
  const Term right = matrix(3, 1, {1 - c.v, number(-1), c.v});
  const Term middle =
      matrix(3, 3,
             {r(c.zero, c.zero), r(c.zero, c.v), r(c.zero, c.one), r(c.u, c.zero), r(c.u, c.v),
              r(c.u, c.one), r(c.one, c.zero), r(c.one, c.v), r(c.one, c.one)});
  const Term nothing = matrix(1, 1, {0 * c.bilinear});
  CHECK(holds(times(times(left, middle), right), nothing));
  const Term wrong = matrix(1, 3, {1 - c.u, number(1), c.u});
  CHECK(fails(times(times(wrong, middle), right), nothing));
}

TEST_CASE("mixed derivatives of an unknown function do not depend on the order") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  const Term f = declare.scalar_function("f", {"u", "v"});
  const Term g = lambda({u, v}, at(f, {u * v, u + v}));
  const Term uv = derivative(derivative(g, {1, 0}), {0, 1});
  const Term vu = derivative(derivative(g, {0, 1}), {1, 0});
  CHECK(holds(at(uv, {u, v}), at(vu, {u, v})));
  CHECK(fails(at(uv, {u, v}), at(derivative(g, {2, 0}), {u, v})));
}

TEST_CASE("the derivative of a reparametrised curve follows the chain rule") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term u0 = declare.scalar("u0");
  const Term u1 = declare.scalar("u1");
  const Term C = declare.curve("C1", "u");
  const Term inner = u0 + (u1 - u0) * u;
  const Term part = lambda({u}, at(C, {inner}));
  const Term second = at(derivative(C, {2}), {inner});
  CHECK(holds(at(derivative(part, {2}), {u}), power(u1 - u0, 2) * second));
  CHECK(fails(at(derivative(part, {2}), {u}), (u1 - u0) * second));
  CHECK(holds(at(part, {number(0)}), at(C, {u0})));
  CHECK(holds(at(derivative(part, {1}), {number(1)}), (u1 - u0) * at(derivative(C, {1}), {u1})));
  CHECK(difference(at(part, {u}), at(C, {u0})) == "C1(-u*u0 + u*u1 + u0) - C1(u0)");
}

TEST_CASE("a curve on [a, b] ends where the curve on [0, 1] does") {
  Declarations declare;
  const Term v = declare.parameter("v");
  const Term a = declare.scalar("a");
  const Term b = declare.scalar("b");
  const Term C = declare.curve("C", "t");
  const Term moved = lambda({v}, at(C, {(v - a) / (b - a)}));
  CHECK(holds(at(moved, {b}), at(C, {number(1)})));
  CHECK(holds(at(moved, {a}), at(C, {number(0)})));
  CHECK(holds(at(derivative(moved, {1}), {b}), 1 / (b - a) * at(derivative(C, {1}), {number(1)})));
  CHECK(fails(at(moved, {b}), at(C, {number(0)})));
  CHECK(holds(at(C, {(v - a) / (b - a)}), at(C, {1 - (b - v) / (b - a)})));
}

TEST_CASE("the parameters of an unknown function are told apart") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  const Term f = declare.scalar_function("f", {"u", "v"});
  const Term edge = lambda({v}, at(f, {number(0), v}));
  const Term across = at(derivative(f, {0, 1}), {number(0), u});
  CHECK(holds(at(derivative(edge, {1}), {u}), across));
  CHECK(fails(at(derivative(edge, {1}), {u}), at(derivative(f, {1, 0}), {number(0), u})));
  CHECK(difference(at(derivative(f, {2, 1}), {u, 2 * v}), number(0)) == "f_uuv(u, 2*v)");
}

TEST_CASE("substitution into a function does not capture its parameters") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  const Term f = lambda({u, v}, u - 2 * v);
  CHECK(holds(at(f, {v, u}), v - 2 * u));
  const Term inner = lambda({v}, at(f, {u, v}));
  CHECK(holds(at(inner, {u}), -u));
}

TEST_CASE("operations on functions act on their values") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term f = lambda({u}, power(u, 2));
  const Term g = declare.scalar_function("g", {"t"});
  const Term both = make_term(Operation::sum, g.type(), {f, g});
  const Term scaled = make_term(Operation::product, g.type(), {u, both});
  CHECK(holds(at(scaled, {number(3)}), u * (9 + at(g, {number(3)}))));
  CHECK(holds(at(derivative(both, {1}), {u}), 2 * u + at(derivative(g, {1}), {u})));
}

TEST_CASE("a difference is named by its first component that is not zero") {
  Declarations declare;
  const Term V = declare.point("V[1,2]", 3);
  const Term W = declare.point("W", 3);
  const Term left = point({component(V, 0), component(V, 1) / 3, component(W, 2)});
  const Term right = point({component(V, 0), power(component(W, 1), 2), number(0)});
  CHECK(difference(left, right) == "1/3*V[1,2].y - W.y^2");
}

TEST_CASE("long differences are cut off") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const std::string form = difference(power(1 + u, 60), number(0));
  CHECK(form.substr(0, 20) == "u^60 + 60*u^59 + 177");
  CHECK(form.substr(form.size() - 6) == " + …");
}

TEST_CASE("rational functions are equal up to common factors") {
  Declarations declare;
  const Term a = declare.scalar("a");
  const Term b = declare.scalar("b");
  CHECK(holds((a * a - b * b) / (a - b), a + b));
  CHECK(holds(1 / (1 / a + 1 / b), a * b / (a + b)));
  CHECK(holds(power(a - b, -2), 1 / (a * a - 2 * a * b + b * b)));
  CHECK(fails((a * a + b * b) / (a - b), a + b));
  CHECK(reason(1 / (power(a + b, 2) - a * a - 2 * a * b - b * b), a) ==
        "a denominator that is zero identically");
}

TEST_CASE("an argument equals one in which quotients cancel only together") {
  Declarations declare;
  const Term t = declare.parameter("t");
  const Term a = declare.scalar("a");
  const Term b = declare.scalar("b");
  const Term curve = declare.curve("C", "t");
  const Term nothing = 1 / a + 1 / b - (a + b) / (a * b);
  CHECK(holds(at(curve, {t + nothing}), at(curve, {t})));
  CHECK(holds(at(curve, {t}), at(curve, {t + nothing})));
  CHECK(fails(at(curve, {t + 2 * nothing + 1}), at(curve, {t})));
}

TEST_CASE("powers and products of many summands are complete") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  const Term dense = 1 + u + power(u, 2) + power(u, 3) + power(u, 4);
  CHECK(holds(power(dense, 31), power(dense, 30) * dense));
  CHECK(holds(power(1 + u, 69) * power(1 + v, 69), power((1 + u) * (1 + v), 69)));
  CHECK(fails(power(dense, 31), power(dense, 30)));
}

TEST_CASE("differences are written in one order, whatever the order of GiNaC") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  const Term a = declare.scalar("a");
  const Term b = declare.scalar("b");
  CHECK(difference(exp(u * v + a * b + u / 2), cos(v * a - u) / (a - b) + 1 / (b + v)) ==
        "v*a*exp(u/2)*exp(u*v)*exp(a*b) - v*b*exp(u/2)*exp(u*v)*exp(a*b) - "
        "1/2*v*exp(i*u)*exp(i*v*a)^-1 - 1/2*v*exp(i*u)^-1*exp(i*v*a) + "
        "a*b*exp(u/2)*exp(u*v)*exp(a*b) - a - b^2*exp(u/2)*exp(u*v)*exp(a*b) - "
        "1/2*b*exp(i*u)*exp(i*v*a)^-1 + b - 1/2*b*exp(i*u)^-1*exp(i*v*a)");
}

TEST_CASE("relations that are no equations, and functions, are not judged") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term f = lambda({u}, u);
  CHECK(opinion(goal({{u, Relation::less, u + 1, {}}})).reason == "a relation that is no equation");
  CHECK(reason(f, f) == "an equation between functions");
}

TEST_CASE("what is too large is given up quickly") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  Term sum = 1 + u + v;
  for (int i = 0; i < 6; ++i) sum = sum + declare.scalar("a" + std::to_string(i));
  const std::clock_t start = std::clock();
  CHECK(reason(power(sum, 500), u) == "over budget: more than 200000 terms");
  CHECK(reason(power(power(1 + u, 4096), 200), u) == "over budget: more than 200000 terms");
  Term tower = number(2);
  for (int i = 0; i < 500; ++i) tower = power(tower, 4096);
  CHECK(reason(tower, u) == "over budget: coefficients of more than 16777216 bits");
  Term letters = u;
  for (int i = 0; i < 500; ++i) letters = power(letters, 4096);
  CHECK(reason(letters, u) == "over budget: an exponent above 1000000");
  Term squares = 1 + u + v;
  for (int i = 0; i < 900; ++i) squares = squares * squares;
  CHECK(reason(squares, u) == "over budget: more than 400000000 steps");
  Term roots = u;
  for (int i = 0; i < 300; ++i) roots = sqrt(1 + roots);
  CHECK(holds(roots, roots));
  CHECK(reason(roots, u) == "the difference is not zero in form, but its parts may be related");
  CHECK((std::clock() - start) / CLOCKS_PER_SEC < 30);
}

TEST_CASE("a limit of time or steps is kept") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  const Goal g = goal({equation(power(1 + u + v, 200), power(1 + v + u, 199) * (1 + u))});
  Limits limits;
  limits.steps = 1000;
  CHECK(second_opinion(g, limits).reason == "over budget: more than 1000 steps");
  limits = {};
  limits.terms = 100;
  CHECK(second_opinion(g, limits).reason == "over budget: more than 100 terms");
}
