#include <patchproof/algebra/polynomial.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

namespace {

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);

}  // namespace

TEST_CASE("polynomials are a commutative ring", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{20};
  const auto add = [&](const Polynomial& a, const Polynomial& b) { return sum(a, b, budget); };
  const auto mul = [&](const Polynomial& a, const Polynomial& b) { return product(a, b, budget); };
  for (int i = 0; i < 300; ++i) {
    const Polynomial a = random_polynomial(random);
    const Polynomial b = random_polynomial(random);
    const Polynomial c = random_polynomial(random);
    INFO(words(a) << "\n" << words(b) << "\n" << words(c));
    CHECK(add(a, b) == add(b, a));
    CHECK(add(add(a, b), c) == add(a, add(b, c)));
    CHECK(mul(a, b) == mul(b, a));
    CHECK(mul(mul(a, b), c) == mul(a, mul(b, c)));
    CHECK(mul(a, add(b, c)) == add(mul(a, b), mul(a, c)));
    CHECK(difference(a, a, budget).is_zero());
    CHECK(add(difference(a, b, budget), b) == a);
    CHECK(mul(a, Rational{1}) == a);
    CHECK(mul(a, Rational{0}).is_zero());
    CHECK(scaled(a, Rational(-2, 3)) == mul(a, Rational(-2, 3)));
  }
}

TEST_CASE("the normal form keeps the value and shows nothing twice", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{21};
  for (int i = 0; i < 200; ++i) {
    const Polynomial a = random_polynomial(random);
    const Polynomial b = random_polynomial(random);
    const Point at = random_point(random);
    INFO(words(a) << "\n" << words(b));
    CHECK(value_at(sum(a, b, budget), at) == value_at(a, at) + value_at(b, at));
    CHECK(value_at(product(a, b, budget), at) == value_at(a, at) * value_at(b, at));
    const Polynomial result = product(a, b, budget);
    for (std::size_t k = 0; k < result.terms().size(); ++k) {
      CHECK(result.terms()[k].coefficient != 0);
      if (k > 0) CHECK(result.terms()[k].monomial < result.terms()[k - 1].monomial);
    }
  }
}

TEST_CASE("a product divided by a factor is the other factor", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{22};
  for (int i = 0; i < 300; ++i) {
    const Polynomial a = random_polynomial(random);
    const Polynomial b = random_nonzero(random);
    INFO(words(a) << "\n" << words(b));
    CHECK(quotient(product(a, b, budget), b, budget) == a);
    // A remainder of lower degree in some variable cannot be divided.
    if (!b.is_constant()) {
      const Polynomial shifted = sum(product(a, b, budget), Rational{1}, budget);
      CHECK_FALSE(quotient(shifted, b, budget));
    }
  }
}

TEST_CASE("what does not divide is said not to divide", "[law]") {
  Budget budget{Limits{}};
  CHECK_FALSE(quotient(x, y, budget));
  CHECK_FALSE(quotient(x, product(x, x, budget), budget));
  CHECK_FALSE(quotient(Rational{1}, x, budget));
  CHECK(quotient(Polynomial{}, x, budget) == Polynomial{});
  CHECK(quotient(x, Rational{2}, budget) == scaled(x, Rational(1, 2)));
  CHECK_THROWS_AS(quotient(x, Polynomial{}, budget), std::domain_error);
}

TEST_CASE("powers are repeated products", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{23};
  for (int i = 0; i < 40; ++i) {
    const Polynomial a = random_polynomial(random, 2, 2, 3);
    Polynomial expected{Rational{1}};
    for (unsigned n = 0; n < 6; ++n) {
      CHECK(power(a, n, budget) == expected);
      expected = product(expected, a, budget);
    }
  }
}

TEST_CASE("derivatives are linear and obey the product rule", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{24};
  for (int i = 0; i < 200; ++i) {
    const Polynomial a = random_polynomial(random);
    const Polynomial b = random_polynomial(random);
    const Variable v = random() % 3;
    INFO(words(a) << "\n" << words(b));
    CHECK(derivative(sum(a, b, budget), v) == sum(derivative(a, v), derivative(b, v), budget));
    CHECK(derivative(product(a, b, budget), v) ==
          sum(product(derivative(a, v), b, budget), product(a, derivative(b, v), budget), budget));
    CHECK(derivative(derivative(a, 0), 1) == derivative(derivative(a, 1), 0));
  }
  CHECK(derivative(power(x, 5, budget), 0) == scaled(power(x, 4, budget), 5));
  CHECK(derivative(y, 0).is_zero());
}

TEST_CASE("the derivative is what remains of the difference quotient at 0", "[law]") {
  // (p(x + h) - p(x)) / h is a polynomial; its value at h = 0 is the derivative.
  Budget budget{Limits{}};
  std::mt19937 random{25};
  const Polynomial h = Polynomial::variable(9);
  for (int i = 0; i < 60; ++i) {
    const Polynomial p = random_polynomial(random);
    const Polynomial moved = substituted(p, {{0, sum(x, h, budget)}}, budget);
    const auto slope = quotient(difference(moved, p, budget), h, budget);
    REQUIRE(slope);
    CHECK(substituted(*slope, {{9, Polynomial{}}}, budget) == derivative(p, 0));
  }
}

TEST_CASE("substitution is a homomorphism of rings", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{26};
  for (int i = 0; i < 100; ++i) {
    const Polynomial a = random_polynomial(random);
    const Polynomial b = random_polynomial(random);
    const std::map<Variable, Polynomial> images{{0, random_polynomial(random, 3, 2, 3)},
                                                {2, random_polynomial(random, 3, 2, 3)}};
    const auto moved = [&](const Polynomial& p) { return substituted(p, images, budget); };
    INFO(words(a) << "\n" << words(b));
    CHECK(moved(sum(a, b, budget)) == sum(moved(a), moved(b), budget));
    CHECK(moved(product(a, b, budget)) == product(moved(a), moved(b), budget));
    const Point at = random_point(random);
    Point inner = at;
    for (const auto& [variable, image] : images) inner[variable] = value_at(image, at);
    CHECK(value_at(moved(a), at) == value_at(a, inner));
  }
}

TEST_CASE("variables are replaced at once, not one after the other") {
  Budget budget{Limits{}};
  const Polynomial p = difference(scaled(x, 2), y, budget);
  CHECK(substituted(p, {{0, y}, {1, x}}, budget) == difference(scaled(y, 2), x, budget));
}

TEST_CASE("the coefficients of powers of a variable make up the polynomial again", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{27};
  for (int i = 0; i < 100; ++i) {
    const Polynomial p = random_polynomial(random);
    const Variable v = random() % 3;
    Polynomial total;
    unsigned exponent = 0;
    for (const Polynomial& c : coefficients(p, v)) {
      CHECK(c.degree(v) == 0);
      const Polynomial part = power(Polynomial::variable(v), exponent++, budget);
      total = sum(total, product(c, part, budget), budget);
    }
    CHECK(total == p);
  }
}

TEST_CASE("divided by its content a polynomial has whole coprime coefficients", "[law]") {
  std::mt19937 random{28};
  for (int i = 0; i < 100; ++i) {
    const Polynomial p = random_nonzero(random);
    const Rational c = content(p);
    REQUIRE(c > 0);
    Integer divisor = 0;
    for (const auto& term : p.terms()) {
      const Rational whole = term.coefficient / c;
      CHECK(denominator(whole) == 1);
      divisor = gcd(divisor, Integer{numerator(whole)});
    }
    CHECK(divisor == 1);
  }
  CHECK(content(Polynomial{}) == 1);
}

TEST_CASE("the order of monomials is preserved by multiplication", "[law]") {
  std::mt19937 random{29};
  const auto monomial = [&] {
    Monomial result;
    for (int k = 0; k < 3; ++k)
      result = result *
               Monomial{static_cast<Variable>(random() % 3), static_cast<unsigned>(random() % 3)};
    return result;
  };
  for (int i = 0; i < 500; ++i) {
    const Monomial a = monomial();
    const Monomial b = monomial();
    const Monomial c = monomial();
    CHECK((a * c < b * c) == (a < b));
    CHECK(quotient(a * c, c) == a);
    CHECK((a * b).total_degree() == a.total_degree() + b.total_degree());
    CHECK((hash_value(a * b) == hash_value(b * a)));
  }
}

TEST_CASE("a product that becomes too large runs over its budget", "[reject]") {
  Limits limits;
  limits.terms = 50;
  Budget budget{limits};
  const Polynomial p =
      sum(sum(x, y, budget), sum(Polynomial::variable(2), Rational{1}, budget), budget);
  CHECK_THROWS_AS(power(p, 12, budget), OverBudget);
}

}  // namespace patchproof
