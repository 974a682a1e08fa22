#include <catch2/catch.hpp>

#include <patchproof/kernel/sign_facts.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

TEST_CASE("what is said of signs with positive symbols holds on a grid", "[law]") {
  // x0 in [0, 1]; x1 > 0; x2 >= 0.
  std::mt19937 random{82};
  int positive = 0;
  int silent = 0;
  for (int i = 0; i < 400; ++i) {
    Budget budget{Limits{}};
    SignFacts facts;
    facts.add_interval(0, {0, 1});
    facts.add_inequality(Polynomial::variable(1), true);
    facts.add_inequality(Polynomial::variable(2), false);
    const Polynomial p =
        sum(random_polynomial(random, 3, 3, 4),
            product(Polynomial::variable(1), Rational{random_small(random, 6)}, budget), budget);
    const bool is_positive = facts.always_positive(p, budget);
    const bool not_negative = facts.never_negative(p, budget);
    const bool not_zero = facts.never_zero(p, budget);
    positive += is_positive && !p.is_constant();
    silent += !is_positive && !not_negative && !not_zero;
    INFO(words(p));
    for (int a = 0; a <= 4; ++a) {
      for (const Rational& b : {Rational(1, 50), Rational(1, 2), Rational(1), Rational(7)}) {
        for (const Rational& c : {Rational(0), Rational(1, 20), Rational(1), Rational(9)}) {
          const Rational v = value_at(p, {{0, Rational(a, 4)}, {1, b}, {2, c}});
          if (is_positive) REQUIRE(v > 0);
          if (not_negative) REQUIRE(v >= 0);
          if (not_zero) REQUIRE(v != 0);
        }
      }
    }
  }
  CHECK(positive > 10);
  CHECK(silent > 30);
}

TEST_CASE("coefficients of Bernstein polynomials may be symbols of known sign") {
  Budget budget{Limits{}};
  const Polynomial t = Polynomial::variable(0);
  const Polynomial v = Polynomial::variable(1);
  const Polynomial w = Polynomial::variable(2);
  const Polynomial rest = difference(Polynomial{Rational{1}}, t, budget);
  // (1-t)*v + t*w
  const Polynomial segment = sum(product(rest, v, budget), product(t, w, budget), budget);
  SignFacts facts;
  facts.add_interval(0, {0, 1});
  CHECK_FALSE(facts.never_zero(segment, budget));
  facts.add_inequality(v, true);
  CHECK_FALSE(facts.never_zero(segment, budget));
  CHECK_FALSE(facts.never_negative(segment, budget));
  facts.add_inequality(w, false);
  CHECK_FALSE(facts.always_positive(segment, budget));
  CHECK(facts.never_negative(segment, budget));
  facts.add_inequality(w, true);
  CHECK(facts.always_positive(segment, budget));
  CHECK(facts.never_zero(segment, budget));
  CHECK(facts.never_zero(product(segment, product(v, v, budget), budget), budget));
  CHECK_FALSE(facts.never_zero(difference(segment, v, budget), budget));
}

TEST_CASE("what is positive is no zero factor either") {
  Budget budget{Limits{}};
  const Polynomial length = difference(Polynomial::variable(1), Polynomial::variable(0), budget);
  const Polynomial square = product(length, length, budget);
  SignFacts facts;
  CHECK_FALSE(facts.never_zero(square, budget));
  facts.add_inequality(length, false);
  CHECK_FALSE(facts.never_zero(square, budget));
  facts.add_inequality(length, true);
  CHECK(facts.never_zero(square, budget));
  CHECK_FALSE(facts.never_zero(product(square, Polynomial::variable(0), budget), budget));
}

TEST_CASE(
    "terms with positive coefficients and positive symbols are positive, others need not be") {
  Budget budget{Limits{}};
  const Polynomial x = Polynomial::variable(0);
  const Polynomial y = Polynomial::variable(1);
  const Polynomial xy = product(x, y, budget);
  SignFacts facts;
  facts.add_inequality(x, true);
  CHECK_FALSE(facts.never_zero(xy, budget));
  CHECK(facts.never_zero(product(x, x, budget), budget));
  facts.add_inequality(y, false);
  CHECK(facts.never_negative(xy, budget));
  CHECK_FALSE(facts.always_positive(xy, budget));
  facts.add_inequality(y, true);
  CHECK(facts.always_positive(xy, budget));
  CHECK(facts.always_positive(sum(xy, product(x, x, budget), budget), budget));
  CHECK_FALSE(facts.never_zero(difference(xy, x, budget), budget));
}

}  // namespace patchproof
