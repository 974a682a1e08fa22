#include <patchproof/kernel/elementary.hpp>

#include <catch2/catch.hpp>

#include <patchproof/kernel/enclose.hpp>

#include "kernel/atoms_for_tests.hpp"

namespace patchproof {

namespace {

constexpr unsigned bits = 80;

bool overlap(const Enclosure& a, const Enclosure& b) { return a.low <= b.high && b.low <= a.high; }

// The value of the fraction agrees with an enclosure of the true number.
bool agrees(const Fraction& value, const Enclosure& truth, Tools& t) {
  const auto found = enclosure(value, t.workspace.atoms, bits, t.budget);
  return found && overlap(*found, truth) && found->high - found->low < Rational(1, 1'000'000);
}

}  // namespace

TEST_CASE("sine and cosine of multiples of pi/12 and pi/5 are what they are", "[law]") {
  for (const int parts : {12, 5, 8}) {
    Tools t;
    for (int k = -30; k <= 30; ++k) {
      const Rational multiple(k, parts);
      const Fraction angle = t.times(t.pi, multiple);
      const Enclosure number = pi_enclosure(bits) * exactly(multiple);
      Fraction c;
      Fraction s;
      t.with_finer_angles([&] {
        c = cosine(angle, t.workspace);
        s = sine(angle, t.workspace);
      });
      INFO("pi*" << to_text(multiple));
      CHECK(agrees(c, cosine(number, bits), t));
      CHECK(agrees(s, sine(number, bits), t));
    }
  }
}

TEST_CASE("multiples of pi/12 are made of square roots alone", "[law]") {
  Tools t;
  for (int k = -24; k <= 48; ++k) {
    const Fraction angle = t.times(t.pi, Rational(k, 12));
    const Fraction c = cosine(angle, t.workspace);
    const Fraction s = sine(angle, t.workspace);
    for (const Fraction& value : {c, s})
      for (const Variable v : variables(value))
        CHECK(t.workspace.atoms[v].kind == Atom::Kind::root);
    CHECK(t.equal(t.add(t.times(c, c), t.times(s, s)), Rational{1}));
  }
}

TEST_CASE("the addition theorems hold for any angles", "[law]") {
  Tools t;
  std::mt19937 random{100};
  for (int i = 0; i < 60; ++i) {
    t.with_finer_angles([&] {
      const auto angle = [&] {
        const Rational a(random_small(random, 3), 1 + static_cast<int>(random() % 3));
        const Rational b(random_small(random, 2), 1 + static_cast<int>(random() % 2));
        return t.add(t.times(a, t.u),
                     t.add(t.times(b, t.a), t.times(t.pi, Rational(random_small(random, 3), 6))));
      };
      const Fraction x = angle();
      const Fraction y = angle();
      const auto cos = [&](const Fraction& z) { return cosine(z, t.workspace); };
      const auto sin = [&](const Fraction& z) { return sine(z, t.workspace); };
      // Not inside CHECK, which would catch FinerAngles.
      const bool of_sum =
          t.equal(cos(t.add(x, y)), t.minus(t.times(cos(x), cos(y)), t.times(sin(x), sin(y))));
      const bool of_difference =
          t.equal(sin(t.minus(x, y)), t.minus(t.times(sin(x), cos(y)), t.times(cos(x), sin(y))));
      const bool on_circle =
          t.equal(t.add(t.times(sin(x), sin(x)), t.times(cos(x), cos(x))), Rational{1});
      const bool half_turn = t.equal(cos(t.add(x, t.pi)), t.times(Rational{-1}, cos(x)));
      const bool reflected = t.equal(sin(t.minus(t.times(t.pi, Rational(1, 2)), x)), cos(x));
      CHECK(of_sum);
      CHECK(of_difference);
      CHECK(on_circle);
      CHECK(half_turn);
      CHECK(reflected);
    });
  }
}

TEST_CASE("exp turns sums into products", "[law]") {
  Tools t;
  std::mt19937 random{101};
  for (int i = 0; i < 60; ++i) {
    t.with_finer_angles([&] {
      const auto exponent = [&] {
        return t.add(
            t.times(Rational(random_small(random, 4), 1 + static_cast<int>(random() % 3)), t.u),
            Rational(random_small(random, 3), 2));
      };
      const Fraction x = exponent();
      const Fraction y = exponent();
      const auto exp = [&](const Fraction& z) { return exponential(z, t.workspace); };
      const bool of_sum = t.equal(exp(t.add(x, y)), t.times(exp(x), exp(y)));
      const bool inverse = t.equal(t.times(exp(x), exp(t.times(Rational{-1}, x))), Rational{1});
      CHECK(of_sum);
      CHECK(inverse);
    });
  }
  CHECK(t.equal(exponential(Fraction{}, t.workspace), Rational{1}));
  CHECK_FALSE(t.equal(exponential(Fraction{Rational{1}}, t.workspace), Rational{1}));
}

TEST_CASE("roots of numbers multiply, and are the positive ones", "[law]") {
  Tools t;
  std::mt19937 random{102};
  Conditions conditions;
  for (int i = 0; i < 100; ++i) {
    const Rational x(1 + static_cast<int>(random() % 60), 1 + static_cast<int>(random() % 12));
    const Rational y(1 + static_cast<int>(random() % 60), 1 + static_cast<int>(random() % 12));
    const auto root = [&](const Rational& z) { return square_root(z, conditions, t.workspace); };
    INFO(to_text(x) << ", " << to_text(y));
    CHECK(t.equal(t.times(root(x), root(x)), x));
    CHECK(t.equal(t.times(root(x), root(y)), root(x * y)));
    CHECK(t.equal(t.over(root(x), root(y)), root(x / y)));
    CHECK(t.equal(root(x * x), x));
    CHECK(agrees(root(x), square_root(exactly(x), bits), t));
  }
  CHECK(conditions.empty());
}

TEST_CASE("the root of a polynomial squares to it and needs it not to be negative", "[law]") {
  Tools t;
  std::mt19937 random{103};
  for (int i = 0; i < 60; ++i) {
    const Fraction p =
        t.add(t.times(Rational{1 + static_cast<int>(random() % 9)}, t.times(t.u, t.u)),
              t.add(t.times(random_rational(random), t.a), random_rational(random)));
    Conditions conditions;
    const Fraction root = square_root(p, conditions, t.workspace);
    CHECK(t.equal(t.times(root, root), p));
    REQUIRE(conditions.size() == 1);
    CHECK(conditions.begin()->kind == Condition::Kind::at_least_zero);
  }
  // The root of a square is not its base: that may be negative.
  Conditions conditions;
  CHECK_FALSE(t.equal(square_root(t.times(t.u, t.u), conditions, t.workspace), t.u));
}

TEST_CASE("signs of exact numbers are certain or not given", "[law]") {
  Tools t;
  Conditions conditions;
  const auto sign_of = [&](const Fraction& x) {
    return certain_sign(x, t.workspace.atoms, t.budget);
  };
  const auto root = [&](int n) { return square_root(Rational{n}, conditions, t.workspace); };
  CHECK(sign_of(t.minus(root(2), Rational(7, 5))) == 1);
  CHECK(sign_of(t.minus(root(2), Rational(17, 12))) == -1);
  CHECK(sign_of(t.minus(t.pi, Rational(355, 113))) == -1);
  CHECK(sign_of(Fraction{}) == 0);
  CHECK_FALSE(sign_of(t.u));
  CHECK_FALSE(sign_of(t.minus(t.add(t.u, t.pi), t.u)) == 0);
  // sqrt(3 - 2 sqrt(2)) == sqrt(2) - 1: zero, but enclosures alone cannot show it.
  const Fraction nested =
      square_root(t.minus(Rational{3}, t.times(Rational{2}, root(2))), conditions, t.workspace);
  CHECK(sign_of(t.minus(nested, t.minus(root(2), Rational{1}))) != 1);
  CHECK(sign_of(t.minus(nested, t.minus(root(2), Rational{1}))) != -1);
}

TEST_CASE("what has no method or no value is said so", "[reject]") {
  Tools t;
  Conditions conditions;
  CHECK_THROWS_WITH(square_root(Rational{-4}, conditions, t.workspace),
                    "the square root of a negative number");
  CHECK_THROWS_AS(square_root(t.over(Rational{1}, t.u), conditions, t.workspace), OutsideTheory);
  CHECK_THROWS_WITH(
      t.with_finer_angles([&] { cosine(t.times(t.pi, Rational(1, 100'003)), t.workspace); }),
      "an angle is cut into more than 240 parts");
  CHECK_THROWS_WITH(cosine(t.times(t.u, Rational{1000}), t.workspace),
                    "a multiple of an angle is larger than 240 times its unit");
}

}  // namespace patchproof
