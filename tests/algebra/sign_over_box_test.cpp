#include <patchproof/algebra/sign_over_box.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

namespace {

using Answer = BoxSign::Answer;

struct Signs {
  Budget budget{Limits{}};
  Box box{{0, {0, 1}}, {1, {0, 1}}};
  const Polynomial u = Polynomial::variable(0);
  const Polynomial v = Polynomial::variable(1);

  Polynomial number(int numerator, int denominator = 1) const {
    return Polynomial{Rational(numerator, denominator)};
  }
  Polynomial plus(const Polynomial& a, const Polynomial& b) { return sum(a, b, budget); }
  Polynomial minus(const Polynomial& a, const Polynomial& b) { return difference(a, b, budget); }
  Polynomial times(const Polynomial& a, const Polynomial& b) { return product(a, b, budget); }
  Polynomial square(const Polynomial& a) { return times(a, a); }
  // t - 2t^2 + t^3, the Hermite polynomial of the slope at 0.
  Polynomial hermite(const Polynomial& t) { return times(t, square(minus(number(1), t))); }
  BoxSign sign(const Polynomial& p, bool strict = false) {
    return sign_over_box(p, box, strict, budget);
  }
};

}  // namespace

TEST_CASE("what subdivision says holds at every point of a grid", "[law]") {
  std::mt19937 random{311};
  int shown = 0;
  int failed = 0;
  for (int i = 0; i < 150; ++i) {
    Signs signs;
    const Polynomial p = signs.plus(random_polynomial(random, 2, 5, 5),
                                    Polynomial{Rational{random_small(random, 6)}});
    const bool strict = i % 2 == 0;
    const BoxSign found = signs.sign(p, strict);
    INFO(words(p));
    REQUIRE(found.answer != Answer::open);
    shown += found.answer == Answer::shown;
    failed += found.answer == Answer::fails;
    if (found.answer == Answer::fails) {
      Point point{{0, 0}, {1, 0}};
      for (const auto& [v, value] : found.point) {
        REQUIRE((0 <= value && value <= 1));
        point[v] = value;
      }
      REQUIRE(value_at(p, point) == found.value);
      REQUIRE((strict ? found.value <= 0 : found.value < 0));
      continue;
    }
    for (int a = 0; a <= 12; ++a)
      for (int b = 0; b <= 12; ++b) {
        const Rational value = value_at(p, {{0, Rational(a, 12)}, {1, Rational(b, 12)}});
        REQUIRE((strict ? value > 0 : value >= 0));
      }
  }
  CHECK(shown > 20);
  CHECK(failed > 20);
}

TEST_CASE("a square and a little more is positive, and a little less is found negative", "[law]") {
  std::mt19937 random{312};
  for (int i = 0; i < 25; ++i) {
    Signs signs;
    const Rational a{1 + static_cast<int>(random() % 6), 7};
    const Rational b{1 + static_cast<int>(random() % 4), 5};
    const Polynomial x = signs.minus(signs.u, Polynomial{a});
    const Polynomial y = signs.minus(signs.v, Polynomial{b});
    const Polynomial mixed = scaled(signs.times(x, y), Rational(random_small(random, 19), 10));
    // Positive definite, as the mixed coefficient is below 2: zero at (a, b) only.
    const Polynomial p = signs.plus(signs.plus(signs.square(x), signs.square(y)), mixed);
    const Polynomial little = signs.number(1, 100'000);
    INFO(words(p));
    CHECK(signs.sign(p).answer == Answer::shown);
    CHECK(signs.sign(signs.plus(p, little), true).answer == Answer::shown);
    const BoxSign touching = signs.sign(p, true);
    CHECK(touching.answer == Answer::fails);
    CHECK(touching.value == 0);
    const BoxSign below = signs.sign(signs.minus(p, little));
    CHECK(below.answer == Answer::fails);
    CHECK(below.value < 0);
  }
}

TEST_CASE("the bulge of a twist is 16/729, attained at (1/3, 1/3)", "[literature]") {
  Signs signs;
  const Polynomial h = signs.hermite(signs.u);
  const Polynomial bulge = signs.times(h, signs.hermite(signs.v));
  const BoxSign one = signs.sign(signs.minus(signs.number(4, 27), h));
  CHECK(one.answer == Answer::shown);
  CHECK(one.tree.boxes == 3);
  const Polynomial gap = signs.minus(signs.number(16, 729), bulge);
  const BoxSign two = signs.sign(gap);
  CHECK(two.answer == Answer::shown);
  CHECK(two.tree.boxes < 20);
  const BoxSign attained = signs.sign(gap, true);
  CHECK(attained.point == std::map<Variable, Rational>{{0, Rational(1, 3)}, {1, Rational(1, 3)}});
  CHECK(attained.value == 0);
  CHECK(signs.sign(signs.minus(gap, signs.number(1, 1'000'000'000))).answer == Answer::fails);
}

TEST_CASE("zeros of even order at irrational places do not stop a polynomial in one variable") {
  Signs signs;
  const Polynomial root = signs.minus(scaled(signs.square(signs.u), 2), signs.number(1));
  const Polynomial linear = signs.minus(scaled(signs.u, 3), signs.number(1));
  CHECK(signs.sign(signs.square(root)).answer == Answer::shown);
  CHECK(signs.sign(signs.times(signs.square(root), signs.square(linear))).answer == Answer::shown);
  CHECK(signs.sign(signs.times(signs.square(root), linear)).answer == Answer::fails);
  CHECK(signs.sign(signs.times(signs.square(root), root)).answer == Answer::fails);
  // Positive but for that place: no fraction is a witness.
  CHECK(signs.sign(signs.square(root), true).answer == Answer::open);
}

TEST_CASE("a zero inside a face of the box is found") {
  Signs signs;
  const Polynomial x = signs.minus(scaled(signs.u, 3), signs.number(1));
  CHECK(signs.sign(signs.plus(signs.square(x), signs.v)).answer == Answer::shown);
  CHECK(signs.sign(signs.minus(signs.square(x), signs.v)).answer == Answer::fails);
}

TEST_CASE("a line of zeros through corners is no obstacle") {
  Signs signs;
  const Polynomial diagonal = signs.square(signs.minus(signs.u, signs.v));
  CHECK(signs.sign(diagonal).answer == Answer::shown);
  CHECK(signs.sign(signs.times(diagonal, signs.plus(signs.u, signs.v))).answer == Answer::shown);
  CHECK(signs.sign(signs.minus(diagonal, scaled(signs.times(signs.u, signs.v), Rational(1, 100))))
            .answer == Answer::fails);
}

TEST_CASE("the polynomial of Motzkin is not negative, though no sum of squares", "[literature]") {
  // Motzkin, The arithmetic-geometric inequality (1967): x^4 y^2 + x^2 y^4 - 3 x^2 y^2 + 1.
  Signs signs;
  signs.box = {{0, {-2, 2}}, {1, {-2, 2}}};
  const Polynomial x = signs.square(signs.u);
  const Polynomial y = signs.square(signs.v);
  const Polynomial xy = signs.times(x, y);
  const Polynomial p =
      signs.plus(signs.minus(signs.times(xy, signs.plus(x, y)), scaled(xy, 3)), signs.number(1));
  CHECK(signs.sign(p).answer == Answer::shown);
  CHECK(signs.sign(p, true).answer == Answer::fails);
  CHECK(signs.sign(signs.minus(p, signs.number(1, 1'000'000))).answer == Answer::fails);
}

TEST_CASE("a side that is a point is a value") {
  Signs signs;
  signs.box = {{0, {1, 1}}, {1, {0, 1}}};
  const BoxSign found = signs.sign(signs.minus(signs.v, signs.u));
  CHECK(found.answer == Answer::fails);
  CHECK(found.point.at(0) == 1);
  CHECK(signs.sign(signs.minus(signs.u, signs.v)).answer == Answer::shown);
}

TEST_CASE("subdivision ends when it does not decide, and when the budget does") {
  Signs signs;
  const Polynomial x = signs.minus(scaled(signs.square(signs.u), 2), signs.number(1));
  const Polynomial y = signs.minus(scaled(signs.square(signs.v), 2), signs.number(1));
  const Polynomial p = signs.plus(signs.square(x), signs.square(y));
  const BoxSign found = signs.sign(p);
  CHECK(found.answer == Answer::open);
  CHECK(found.tree.boxes <= most_boxes);
  Limits few;
  few.steps = 2000;
  Budget budget{few};
  CHECK_THROWS_AS(sign_over_box(p, signs.box, false, budget), OverBudget);
}

}  // namespace patchproof
