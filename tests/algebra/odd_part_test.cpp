#include <patchproof/algebra/odd_part.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

TEST_CASE("the odd part has the sign of the polynomial, and only simple zeros", "[law]") {
  std::mt19937 random{321};
  for (int i = 0; i < 60; ++i) {
    Budget budget{Limits{}};
    Polynomial p{Rational{1 + random_small(random, 3) * 2}};
    for (unsigned k = 0; k < 1 + random() % 3; ++k) {
      const Polynomial factor = random_nonzero(random, 1, 2, 3);
      p = product(p, power(factor, 1 + random() % 3, budget), budget);
    }
    const Polynomial odd = odd_part(p, 0, budget);
    INFO(words(p) << " has the odd part " << words(odd));
    CHECK(odd.degree(0) <= p.degree(0));
    for (int a = -30; a <= 30; ++a) {
      const Rational value = value_at(p, {{0, Rational(a, 7)}});
      if (value == 0) continue;
      REQUIRE((value > 0) == (value_at(odd, {{0, Rational(a, 7)}}) > 0));
    }
    if (odd.is_constant()) continue;
    CHECK(odd_part(odd, 0, budget).degree(0) == odd.degree(0));
  }
}

TEST_CASE("(x - 1)^2 (x^2 - 2)^3 has the odd part x^2 - 2") {
  Budget budget{Limits{}};
  const Polynomial x = Polynomial::variable(0);
  const Polynomial a = difference(x, Rational{1}, budget);
  const Polynomial b = difference(product(x, x, budget), Rational{2}, budget);
  const Polynomial p = product(power(a, 2, budget), power(b, 3, budget), budget);
  CHECK(odd_part(p, 0, budget) == b);
  CHECK(odd_part(scaled(p, -5), 0, budget) == scaled(b, -1));
  CHECK(odd_part(power(a, 4, budget), 0, budget).is_constant());
}

}  // namespace patchproof
