#include <patchproof/algebra/corner_chart.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

TEST_CASE("blown up at a corner, a polynomial is a power of s times the chart", "[law]") {
  std::mt19937 random{331};
  const Box box{{0, {0, 1}}, {1, {0, 1}}};
  for (int i = 0; i < 60; ++i) {
    Budget budget{Limits{}};
    const Polynomial p = random_nonzero(random, 2, 5, 5);
    const BernsteinForm form{p, box, budget};
    const unsigned corner = random() % 4;
    const std::size_t largest = random() % 2;
    const CornerChart chart{form, corner, largest, budget};
    std::optional<Rational> power;
    for (int k = 0; k < 6; ++k) {
      Point at;
      at[static_cast<Variable>(largest)] = Rational(1, 2);
      at[static_cast<Variable>(1 - largest)] = Rational(static_cast<int>(random() % 8), 7);
      const Rational inner = value_at(chart.polynomial(), at);
      const std::vector<Rational> place = chart.place(at, budget);
      const Rational outer = value_at(p, {{0, place[0]}, {1, place[1]}}) / form.scale();
      INFO(words(p) << " at corner " << corner);
      if (inner == 0) {
        REQUIRE(outer == 0);
        continue;
      }
      // The same power of s = 1/2 for all points of the chart.
      if (!power) power = outer / inner;
      REQUIRE(outer / inner == *power);
      REQUIRE(numerator(*power) == 1);
    }
  }
}

TEST_CASE("where s is zero the sign shows near the corner") {
  Budget budget{Limits{}};
  // x y - x^2 y - x^2 is negative for small x where y < x, as x (y - x y - x).
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial square = product(x, x, budget);
  const Polynomial p = difference(
      difference(product(x, y, budget), product(square, y, budget), budget), square, budget);
  const Box box{{0, {0, 1}}, {1, {0, 1}}};
  const CornerChart chart{BernsteinForm{p, box, budget}, 0, 0, budget};
  const std::vector<Rational> place = chart.place({{0, 0}, {1, Rational(1, 2)}}, budget);
  CHECK(place[0] > 0);
  CHECK(value_at(p, {{0, place[0]}, {1, place[1]}}) < 0);
}

}  // namespace patchproof
