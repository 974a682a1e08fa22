#include <patchproof/symbolic/exponentials.hpp>

#include <catch2/catch.hpp>

#include <tests/symbolic/terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

const std::string related = "the difference is not zero in form, but its parts may be related";

}  // namespace

TEST_CASE("sines and cosines follow Pythagoras and the addition theorems") {
  Declarations declare;
  const Term x = declare.parameter("x");
  const Term y = declare.scalar("y");
  CHECK(holds(power(sin(x), 2) + power(cos(x), 2), number(1)));
  CHECK(holds(sin(2 * x), 2 * (sin(x) * cos(x))));
  CHECK(holds(sin(x + y), sin(x) * cos(y) + cos(x) * sin(y)));
  CHECK(holds(cos(x / 3), 4 * power(cos(x / 9), 3) - 3 * cos(x / 9)));
  CHECK(holds(cos(x * y) * cos(x * y), (1 + cos(2 * (y * x))) / 2));
  CHECK(holds(sin(-x), -sin(x)));
  CHECK(fails(sin(2 * x), 2 * sin(x)));
  CHECK(fails(sin(x + y), sin(x) * cos(y) - cos(x) * sin(y)));
  CHECK(fails(sin(x), x));
  CHECK(difference(sin(x), number(0)) == "(-1/2*i)*exp(i*x) + (1/2*i)*exp(i*x)^-1");
}

TEST_CASE("the quarter circle (sin, cos)(pi/2 u) lies on the cylinder and has its ends") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term C = lambda({u}, point({u, sin(pi() / 2 * u), cos(pi() / 2 * u)}));
  const Term y = component(at(C, {u}), 1);
  const Term z = component(at(C, {u}), 2);
  CHECK(holds(y * y + z * z, number(1)));
  CHECK(holds(at(C, {number(1)}), point({number(1), number(1), number(0)})));
  CHECK(holds(at(C, {number(0)}), point({number(0), number(0), number(1)})));
  CHECK(holds(component(at(derivative(C, {2}), {u}), 1), -(pi() * pi() / 4 * y)));
  CHECK(fails(at(C, {number(1)}), point({number(1), number(0), number(1)})));
  CHECK(fails(component(at(derivative(C, {1}), {u}), 1), pi() * z));
}

TEST_CASE("exact values at multiples of pi/12 are square roots", "[literature]") {
  const Term six = sqrt(number(6));
  const Term two = sqrt(number(2));
  CHECK(holds(cos(pi() / 12), (six + two) / 4));
  CHECK(holds(sin(pi() / 12), (six - two) / 4));
  CHECK(holds(sin(7 * pi() / 12), cos(pi() / 12)));
  CHECK(holds(cos(25 * pi() / 4), two / 2));
  CHECK(holds(sin(-(pi() / 6)), number(-1, 2)));
  CHECK(fails(cos(pi() / 12), (six - two) / 4));
}

TEST_CASE("exact values at other multiples of pi are compared in cyclotomic fields",
          "[literature]") {
  CHECK(holds(cos(pi() / 5), (1 + sqrt(number(5))) / 4));
  CHECK(fails(cos(pi() / 5), (1 - sqrt(number(5))) / 4));
  CHECK(holds(cos(pi() / 7) - cos(2 * pi() / 7) + cos(3 * pi() / 7), number(1, 2)));
  CHECK(holds(8 * (sin(pi() / 7) * (sin(2 * pi() / 7) * sin(3 * pi() / 7))), sqrt(number(7))));
  CHECK(holds(cos(pi() / 24) * cos(pi() / 24), (2 + (sqrt(number(6)) + sqrt(number(2))) / 2) / 4));
  CHECK(holds(sin(pi() / 10), cos(2 * pi() / 5)));
  CHECK(fails(cos(pi() / 7), number(9, 10)));
  CHECK(fails(8 * (sin(pi() / 7) * (sin(2 * pi() / 7) * sin(3 * pi() / 7))), -sqrt(number(7))));
  // Gauss: the regular polygon with 17 sides, its central angle cosine satisfies a quadratic chain.
  const Term eta = 2 * cos(2 * pi() / 17) + 2 * cos(4 * pi() / 17) + 2 * cos(8 * pi() / 17) +
                   2 * cos(16 * pi() / 17);
  CHECK(holds(eta, (sqrt(number(17)) - 1) / 2));
}

TEST_CASE("powers of e multiply by adding exponents") {
  Declarations declare;
  const Term x = declare.parameter("x");
  const Term y = declare.scalar("y");
  CHECK(holds(exp(x + y / 2) * exp(y / 2), exp(x + y)));
  CHECK(holds(power(exp(x / 3), 3), exp(x)));
  CHECK(holds(exp(number(0)), number(1)));
  CHECK(holds(at(derivative(lambda({x}, exp(x * x)), {1}), {x}), 2 * x * exp(x * x)));
  CHECK(fails(exp(x), 1 + x));
  CHECK(fails(exp(number(1)), number(3)));
  CHECK(opinion(exp(pi()), number(23)).reason == related);
  CHECK(opinion(exp(number(1)), pi()).reason == related);
}

TEST_CASE("square roots of numbers have their primes apart") {
  const auto root = [](long a, long b = 1) { return sqrt(number(a, b)); };
  CHECK(holds(root(8), 2 * root(2)));
  CHECK(holds(root(2) * root(3), root(6)));
  CHECK(holds(root(1, 2), root(2) / 2));
  CHECK(holds(1 / (1 + root(2)), root(2) - 1));
  CHECK(holds(root(49, 4), number(7, 2)));
  CHECK(holds(root(0), number(0)));
  CHECK(holds(root(10007L * 10009L), root(10007) * root(10009)));
  CHECK(fails(root(2) + root(3), root(5)));
  CHECK(fails(root(2), number(3, 2)));
  CHECK(opinion(root(-2), number(1)).reason == "the square root of a number that is not positive");
}

TEST_CASE("square roots of polynomials are known by their squares") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term v = declare.parameter("v");
  const Term root = sqrt(1 + u * u);
  CHECK(holds(root * root, 1 + u * u));
  CHECK(holds(sqrt(4 + 4 * (u * u)), 2 * root));
  CHECK(holds(1 / root, root / (1 + u * u)));
  CHECK(holds(at(derivative(lambda({u}, root), {1}), {u}), u / root));
  CHECK(holds(sqrt(power(sin(u), 2) + power(cos(u), 2)), number(1)));
  CHECK(holds(at(lambda({u}, root), {number(1)}), sqrt(number(2))));
  CHECK(fails(root, 1 + u));
  CHECK(fails(root * sqrt(1 + v * v), 1 + u * v));
  CHECK(opinion(sqrt(u * u), u).reason == related);
  CHECK(opinion(sqrt(u) * sqrt(v), sqrt(u * v)).reason == related);
}

TEST_CASE("functions of equal angles are equal, whatever the angles look like") {
  Declarations declare;
  const Term u = declare.parameter("u");
  const Term f = declare.scalar_function("f", {"t"});
  CHECK(holds(at(f, {sin(2 * u)}), at(f, {2 * (sin(u) * cos(u))})));
  CHECK(holds(at(f, {cos(pi() / 5)}), at(f, {(1 + sqrt(number(5))) / 4})));
  CHECK(holds(sin(sin(u)), -sin(sin(-u))));
  CHECK(opinion(at(f, {sin(u)}), at(f, {u})).reason == related);
}
