#include <patchproof/algebra/squares.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

TEST_CASE("the root of a square is found, and only of a square", "[law]") {
  std::mt19937 random{341};
  for (int i = 0; i < 100; ++i) {
    Budget budget{Limits{}};
    const Polynomial root = random_nonzero(random, 3, 3, 4);
    const Polynomial p = scaled(product(root, root, budget), Rational(1 + i % 5, 3));
    INFO(words(p));
    const auto found = square_root(p, budget);
    REQUIRE(found);
    const auto ratio = quotient(p, product(*found, *found, budget), budget);
    REQUIRE(ratio);
    CHECK((ratio->is_constant() && ratio->constant() > 0));
    CHECK_FALSE(square_root(scaled(p, -1), budget));
    const Polynomial other = sum(p, product(Polynomial::variable(0), root, budget), budget);
    if (const auto wrong = square_root(other, budget))
      CHECK(quotient(other, product(*wrong, *wrong, budget), budget));
  }
}

TEST_CASE("a definite polynomial of degree two has one sign everywhere", "[law]") {
  std::mt19937 random{342};
  int weakly = 0;
  int strictly = 0;
  for (int i = 0; i < 300; ++i) {
    Budget budget{Limits{}};
    Polynomial p{Rational{random_small(random, 2)}};
    for (int k = 0; k < 2; ++k) {
      const Polynomial line = random_polynomial(random, 2, 1, 3);
      p = sum(p, scaled(product(line, line, budget), 1 + random_small(random, 1)), budget);
    }
    const bool not_negative = is_definite(p, false, budget);
    const bool positive = is_definite(p, true, budget);
    weakly += not_negative;
    strictly += positive;
    INFO(words(p));
    CHECK((not_negative || !positive));
    for (int k = 0; k < 40; ++k) {
      const Rational value = value_at(p, random_point(random, 2));
      if (not_negative) REQUIRE(value >= 0);
      if (positive) REQUIRE(value > 0);
    }
  }
  CHECK(weakly > 50);
  CHECK(strictly > 20);
  CHECK(weakly > strictly);
}

TEST_CASE("x^2 - x*y + y^2 is definite, x^2 - 3*x*y + y^2 is not") {
  Budget budget{Limits{}};
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial xy = product(x, y, budget);
  const Polynomial squares = sum(product(x, x, budget), product(y, y, budget), budget);
  CHECK(is_definite(difference(squares, xy, budget), false, budget));
  CHECK_FALSE(is_definite(difference(squares, xy, budget), true, budget));
  CHECK(is_definite(sum(squares, Rational{1}, budget), true, budget));
  CHECK_FALSE(is_definite(difference(squares, scaled(xy, 3), budget), false, budget));
  CHECK_FALSE(is_definite(sum(product(x, x, budget), y, budget), false, budget));
  CHECK_FALSE(is_definite(power(x, 4, budget), false, budget));
}

}  // namespace patchproof
