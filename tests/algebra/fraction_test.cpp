#include <patchproof/algebra/fraction.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

namespace {

Fraction random_fraction(std::mt19937& random, Budget& budget) {
  return quotient(Fraction{random_polynomial(random, 2, 2, 3)},
                  Fraction{random_nonzero(random, 2, 2, 2)}, budget);
}

// A point where none of the fractions is divided by zero.
Point good_point(std::mt19937& random, const std::vector<Fraction>& fractions) {
  for (;;) {
    Point at = random_point(random, 2);
    bool good = true;
    for (const Fraction& f : fractions) good = good && denominator_at(f, at) != 0;
    if (good) return at;
  }
}

bool same(const Fraction& a, const Fraction& b) { return !(a < b) && !(b < a); }

}  // namespace

TEST_CASE("fractions add, multiply and divide as their values do", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{30};
  for (int i = 0; i < 200; ++i) {
    const Fraction a = random_fraction(random, budget);
    const Fraction b = random_fraction(random, budget);
    const Point at = good_point(random, {a, b});
    INFO(words(a) << "\n" << words(b));
    CHECK(value_at(sum(a, b, budget), at) == value_at(a, at) + value_at(b, at));
    CHECK(value_at(difference(a, b, budget), at) == value_at(a, at) - value_at(b, at));
    CHECK(value_at(product(a, b, budget), at) == value_at(a, at) * value_at(b, at));
    if (!b.is_zero() && value_at(b, at) != 0)
      CHECK(value_at(quotient(a, b, budget), at) == value_at(a, at) / value_at(b, at));
    CHECK(value_at(power(a, 3, budget), at) == power(value_at(a, at), 3));
    if (value_at(b, at) != 0)
      CHECK(value_at(power(b, -2, budget), at) == power(value_at(b, at), -2));
  }
}

TEST_CASE("the difference of equal fractions is zero however they were made", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{31};
  for (int i = 0; i < 150; ++i) {
    const Fraction a = random_fraction(random, budget);
    const Fraction b = random_fraction(random, budget);
    const Fraction c = random_fraction(random, budget);
    INFO(words(a) << "\n" << words(b) << "\n" << words(c));
    const Fraction left = product(a, sum(b, c, budget), budget);
    const Fraction right = sum(product(a, b, budget), product(a, c, budget), budget);
    CHECK(difference(left, right, budget).is_zero());
    if (b.is_zero()) continue;
    CHECK(difference(product(quotient(a, b, budget), b, budget), a, budget).is_zero());
  }
}

TEST_CASE("denominators are primitive polynomials with a positive first coefficient", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{32};
  for (int i = 0; i < 100; ++i) {
    const Fraction a =
        sum(random_fraction(random, budget), random_fraction(random, budget), budget);
    for (const auto& [factor, exponent] : a.denominator()) {
      CHECK(exponent >= 1);
      CHECK(content(factor) == 1);
      CHECK(factor.terms().front().coefficient > 0);
      CHECK_FALSE(factor.is_constant());
      // What divides the numerator has been cancelled.
      CHECK_FALSE(quotient(a.numerator(), factor, budget));
    }
  }
}

TEST_CASE("replacing variables of a fraction goes with its value", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{33};
  int compared = 0;
  for (int i = 0; i < 100; ++i) {
    const Fraction a = random_fraction(random, budget);
    const std::map<Variable, Fraction> images{{0, random_fraction(random, budget)},
                                              {1, random_fraction(random, budget)}};
    try {
      const Fraction moved = substituted(a, images, budget);
      const Point at = good_point(random, {images.at(0), images.at(1), moved});
      const Point inner{{0, value_at(images.at(0), at)}, {1, value_at(images.at(1), at)}};
      if (denominator_at(a, inner) == 0) continue;
      INFO(words(a));
      CHECK(value_at(moved, at) == value_at(a, inner));
      ++compared;
    } catch (const std::domain_error&) {
      // The denominator has become zero: allowed, and rare.
    }
  }
  CHECK(compared > 80);
}

TEST_CASE("a polynomial is its scale times its primitive part", "[law]") {
  std::mt19937 random{34};
  for (int i = 0; i < 100; ++i) {
    const Polynomial p = random_nonzero(random);
    const Primitive parts = primitive(p);
    CHECK(scaled(parts.polynomial, parts.scale) == p);
    CHECK(content(parts.polynomial) == 1);
    CHECK(parts.polynomial.terms().front().coefficient > 0);
  }
}

TEST_CASE("factors of a denominator multiply out to it") {
  Budget budget{Limits{}};
  const Polynomial x = Polynomial::variable(0);
  const Polynomial shifted = sum(x, Rational{1}, budget);
  CHECK(expanded({{x, 2}, {shifted, 1}}, budget) ==
        sum(power(x, 3, budget), power(x, 2, budget), budget));
  CHECK(expanded({}, budget) == Polynomial{Rational{1}});
}

TEST_CASE("common factors are cancelled and the condition is not the fraction's to remember") {
  Budget budget{Limits{}};
  const Polynomial x = Polynomial::variable(0);
  const Fraction one = quotient(Fraction{x}, Fraction{x}, budget);
  CHECK(one.is_polynomial());
  CHECK(same(one, Fraction{Rational{1}}));
  const Polynomial square = difference(product(x, x, budget), Rational{1}, budget);
  const Polynomial root = difference(x, Rational{1}, budget);
  CHECK(same(quotient(Fraction{square}, Fraction{root}, budget),
             Fraction{sum(x, Rational{1}, budget)}));
}

TEST_CASE("nothing is divided by zero", "[reject]") {
  Budget budget{Limits{}};
  const Fraction x{Polynomial::variable(0)};
  const Fraction zero = difference(x, x, budget);
  CHECK_THROWS_AS(quotient(x, zero, budget), std::domain_error);
  CHECK_THROWS_AS(power(zero, -1, budget), std::domain_error);
  const Fraction inverse = power(x, -1, budget);
  CHECK_THROWS_AS(substituted(inverse, {{0, Fraction{}}}, budget), std::domain_error);
  CHECK(power(zero, 0, budget).numerator() == Polynomial{Rational{1}});
}

}  // namespace patchproof
