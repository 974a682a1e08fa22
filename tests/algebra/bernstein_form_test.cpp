#include <patchproof/algebra/bernstein_form.hpp>

#include <algorithm>
#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

namespace {

Box random_box(std::mt19937& random, unsigned variables) {
  Box box;
  for (Variable v = 0; v < variables; ++v) {
    const Rational low = random_rational(random);
    box[v] = {low, low + Rational(1 + static_cast<int>(random() % 5), 3)};
  }
  return box;
}

// The point of the box with the local coordinates.
Point at(const Box& box, const std::vector<Rational>& local) {
  Point point;
  for (const auto& [v, side] : box) point[v] = side.low + (side.high - side.low) * local[v];
  return point;
}

}  // namespace

TEST_CASE("Bernstein coefficients enclose the values on the box", "[law]") {
  std::mt19937 random{301};
  for (int i = 0; i < 60; ++i) {
    Budget budget{Limits{}};
    const unsigned variables = 1 + random() % 3;
    const Box box = random_box(random, variables);
    const Polynomial p = random_polynomial(random, variables, 5, 6);
    const BernsteinForm form{p, box, budget};
    const auto& all = form.coefficients();
    const Rational least = Rational{*std::min_element(all.begin(), all.end())} * form.scale();
    const Rational most = Rational{*std::max_element(all.begin(), all.end())} * form.scale();
    CHECK(form.scale() > 0);
    for (int k = 0; k < 20; ++k) {
      std::vector<Rational> local;
      for (unsigned v = 0; v < variables; ++v) local.emplace_back(random() % 13, 12);
      const Rational value = value_at(p, at(box, local));
      INFO(words(p));
      REQUIRE(form.value(local, budget) == value);
      REQUIRE(least <= value);
      REQUIRE(value <= most);
    }
  }
}

TEST_CASE("the coefficients at the corners are the values there", "[law]") {
  std::mt19937 random{302};
  for (int i = 0; i < 40; ++i) {
    Budget budget{Limits{}};
    const Box box = random_box(random, 2);
    const Polynomial p = random_polynomial(random, 2, 4, 6);
    const BernsteinForm form{p, box, budget};
    for (unsigned bits = 0; bits < 4; ++bits) {
      const Point corner = at(box, {Rational{bits & 1U}, Rational{bits >> 1U}});
      CHECK(Rational{form.coefficients()[form.corner(bits)]} * form.scale() == value_at(p, corner));
    }
  }
}

TEST_CASE("the parts of a cut are the same polynomial", "[law]") {
  std::mt19937 random{303};
  for (int i = 0; i < 40; ++i) {
    Budget budget{Limits{}};
    const Box box = random_box(random, 2);
    const Polynomial p = random_polynomial(random, 2, 5, 6);
    const std::size_t axis = random() % 2;
    const Rational cut{1 + static_cast<int>(random() % 6), 7};
    const auto [low, high] = BernsteinForm{p, box, budget}.split(axis, cut, budget);
    for (const bool upper : {false, true}) {
      std::vector<Rational> local{Rational(random() % 5, 4), Rational(random() % 5, 4)};
      std::vector<Rational> outer = local;
      outer[axis] = upper ? Rational{cut + (1 - cut) * local[axis]} : Rational{cut * local[axis]};
      CHECK((upper ? high : low).value(local, budget) == value_at(p, at(box, outer)));
    }
  }
}

TEST_CASE("the Bernstein coefficients of a power are the known ones", "[literature]") {
  // Farin, Curves and Surfaces for CAGD, ch. 5: t = sum k/n B_k^n, t^2 = sum k(k-1)/(n(n-1)) B_k^n.
  Budget budget{Limits{}};
  const Polynomial t = Polynomial::variable(0);
  const Polynomial p = sum(power(t, 4, budget), power(t, 2, budget), budget);
  const BernsteinForm form{p, {{0, {0, 1}}}, budget};
  std::vector<Rational> values;
  for (const Integer& c : form.coefficients()) values.push_back(Rational{c} * form.scale());
  CHECK(values == std::vector<Rational>{0, 0, Rational(1, 6), Rational(1, 2), 2});
}

}  // namespace patchproof
