#include <patchproof/kernel/sign_facts.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

namespace {

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);

struct Signs {
  Budget budget{Limits{}};
  SignFacts facts;
  bool never_zero(const Polynomial& p) { return facts.never_zero(p, budget); }
  bool never_negative(const Polynomial& p) { return facts.never_negative(p, budget); }
  bool always_positive(const Polynomial& p) { return facts.always_positive(p, budget); }
  Polynomial minus(const Polynomial& a, const Polynomial& b) { return difference(a, b, budget); }
  Polynomial plus(const Polynomial& a, const Polynomial& b) { return sum(a, b, budget); }
  Polynomial times(const Polynomial& a, const Polynomial& b) { return product(a, b, budget); }
};

}  // namespace

TEST_CASE("what is said of signs over a box holds at every point of a grid", "[law]") {
  std::mt19937 random{80};
  int positive = 0;
  int silent = 0;
  for (int i = 0; i < 300; ++i) {
    Signs signs;
    const Rational low = random_small(random, 2);
    const Rational high = low + Rational(1 + static_cast<int>(random() % 3), 2);
    signs.facts.add_interval(0, {low, high});
    signs.facts.add_interval(1, {0, 1});
    const Polynomial p =
        signs.plus(random_polynomial(random, 2, 3, 4), Rational{random_small(random, 6)});
    const bool is_positive = signs.always_positive(p);
    const bool not_negative = signs.never_negative(p);
    const bool not_zero = signs.never_zero(p);
    positive += is_positive;
    silent += !is_positive && !not_negative && !not_zero;
    if (is_positive) {
      CHECK(not_negative);
      CHECK(not_zero);
    }
    INFO(words(p) << " for x0 in " << to_text(low) << ", " << to_text(high));
    for (int a = 0; a <= 8; ++a) {
      for (int b = 0; b <= 8; ++b) {
        const Rational v = value_at(p, {{0, low + (high - low) * a / 8}, {1, Rational(b, 8)}});
        if (is_positive) REQUIRE(v > 0);
        if (not_negative) REQUIRE(v >= 0);
        if (not_zero) REQUIRE(v != 0);
      }
    }
  }
  CHECK(positive > 30);
  CHECK(silent > 30);
}

TEST_CASE("what follows from linear inequalities holds wherever they do", "[law]") {
  std::mt19937 random{81};
  int shown = 0;
  for (int i = 0; i < 300; ++i) {
    Signs signs;
    std::vector<SignFacts::Inequality> given;
    for (unsigned k = 0; k < 2 + random() % 3; ++k) {
      const bool strict = random() % 2 == 0;
      const Polynomial p = random_polynomial(random, 2, 1, 3);
      given.push_back({p, strict});
      signs.facts.add_inequality(p, strict);
    }
    const Polynomial claim = random_polynomial(random, 2, 1, 3);
    const bool not_negative = signs.never_negative(claim);
    const bool is_positive = signs.always_positive(claim);
    const bool not_zero = signs.never_zero(claim);
    const bool contradictory = signs.facts.contradictory(signs.budget);
    shown += not_negative && !contradictory && !claim.is_constant();
    for (int a = -12; a <= 12; ++a) {
      for (int b = -12; b <= 12; ++b) {
        const Point at{{0, Rational(a, 2)}, {1, Rational(b, 2)}};
        bool allowed = true;
        for (const auto& [p, strict] : given) {
          const Rational v = value_at(p, at);
          allowed = allowed && (strict ? v > 0 : v >= 0);
        }
        if (!allowed) continue;
        REQUIRE_FALSE(contradictory);
        if (claim.is_constant()) continue;
        if (not_negative) REQUIRE(value_at(claim, at) >= 0);
        if (is_positive) REQUIRE(value_at(claim, at) > 0);
        if (not_zero) REQUIRE(value_at(claim, at) != 0);
      }
    }
  }
  CHECK(shown > 5);
}

TEST_CASE("an interval with its ends does not make its parameter positive") {
  Signs signs;
  signs.facts.add_interval(0, {0, 1});
  CHECK(signs.never_negative(x));
  CHECK_FALSE(signs.always_positive(x));
  CHECK_FALSE(signs.never_zero(x));
  CHECK_FALSE(signs.never_zero(signs.minus(x, Rational{1})));
  CHECK(signs.never_zero(signs.minus(x, Rational(1001, 1000))));
  CHECK(signs.always_positive(signs.plus(x, Rational(1, 1000))));
  CHECK(signs.never_negative(signs.times(x, signs.minus(Rational{1}, x))));
  CHECK_FALSE(signs.always_positive(signs.times(x, signs.minus(Rational{1}, x))));
  CHECK_FALSE(signs.never_negative(scaled(x, -1)));
}

TEST_CASE("without an interval a parameter has any sign") {
  Signs signs;
  CHECK_FALSE(signs.never_negative(x));
  CHECK_FALSE(signs.never_zero(signs.plus(x, Rational{5})));
  signs.facts.add_interval(1, {0, 1});
  CHECK_FALSE(signs.never_negative(signs.times(x, y)));
}

TEST_CASE("sums of even powers are not negative, and positive only with a constant") {
  Signs signs;
  const Polynomial squares = signs.plus(signs.times(x, x), signs.times(y, y));
  CHECK(signs.never_negative(squares));
  CHECK_FALSE(signs.always_positive(squares));
  CHECK_FALSE(signs.never_zero(squares));
  CHECK(signs.never_zero(signs.plus(squares, Rational{1})));
  CHECK_FALSE(signs.never_negative(signs.minus(signs.times(x, x), Rational{1})));
  CHECK_FALSE(signs.never_negative(signs.times(signs.times(x, x), y)));
  CHECK_FALSE(signs.never_negative(signs.minus(signs.times(x, x), signs.times(y, y))));
}

TEST_CASE("a product does not vanish when each of its factors is known not to") {
  Signs signs;
  const Polynomial minus = signs.minus(x, y);
  signs.facts.add_not_zero(scaled(minus, Rational(-7, 3)));
  CHECK(signs.never_zero(minus));
  CHECK(signs.never_zero(scaled(power(minus, 3, signs.budget), 5)));
  CHECK_FALSE(signs.never_zero(signs.times(minus, x)));
  CHECK_FALSE(signs.never_zero(signs.plus(x, y)));
  CHECK_FALSE(signs.never_zero(signs.plus(minus, Rational{1})));
  CHECK_FALSE(signs.never_negative(minus));
  signs.facts.add_not_zero(x);
  CHECK(signs.never_zero(signs.times(minus, x)));
}

TEST_CASE("facts contradict each other when no numbers can satisfy them all") {
  const auto contradictory = [](const std::vector<SignFacts::Inequality>& given,
                                const std::vector<Polynomial>& not_zero) {
    Signs signs;
    for (const auto& [p, strict] : given) signs.facts.add_inequality(p, strict);
    for (const Polynomial& p : not_zero) signs.facts.add_not_zero(p);
    return signs.facts.contradictory(signs.budget);
  };
  const Polynomial minus_x = scaled(x, -1);
  CHECK_FALSE(contradictory({{x, false}, {minus_x, false}}, {}));
  CHECK(contradictory({{x, true}, {minus_x, false}}, {}));
  CHECK(contradictory({{x, false}, {minus_x, false}}, {x}));
  CHECK_FALSE(contradictory({{x, false}, {minus_x, false}}, {y}));
  CHECK_FALSE(contradictory({{x, false}}, {x}));
  CHECK(contradictory({{Rational{-1}, false}}, {}));
  CHECK(contradictory({{Rational{0}, true}}, {}));
  CHECK_FALSE(contradictory({{Rational{0}, false}}, {}));
  CHECK(contradictory({}, {Polynomial{}}));
}

TEST_CASE("only polynomials of degree one are linear constraints") {
  Budget budget{Limits{}};
  using Kind = LinearConstraint::Kind;
  const auto found = linear_constraint(sum(scaled(x, 3), Rational{-2}, budget), Kind::zero);
  REQUIRE(found);
  CHECK(found->coefficients == std::map<unsigned, Rational>{{0, 3}});
  CHECK(found->constant == -2);
  CHECK_FALSE(linear_constraint(product(x, y, budget), Kind::zero));
  CHECK_FALSE(linear_constraint(product(x, x, budget), Kind::zero));
}

}  // namespace patchproof
