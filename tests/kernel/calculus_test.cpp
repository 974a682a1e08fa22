#include <catch2/catch.hpp>

#include "kernel/atoms_for_tests.hpp"

namespace patchproof {

namespace {

Fraction derivative_in_u(const Fraction& value, Tools& t) {
  Conditions conditions;
  const Fraction result = derivative(value, Tools::variable_of(t.u), conditions, t.workspace);
  CHECK(conditions.empty());
  return result;
}

}  // namespace

TEST_CASE("of polynomials the kernel has the derivatives of polynomials", "[law]") {
  Tools t;
  std::mt19937 random{90};
  const Variable u = Tools::variable_of(t.u);
  for (int i = 0; i < 60; ++i) {
    const Polynomial p =
        substituted(random_polynomial(random),
                    {{0, t.u.numerator()}, {1, t.v.numerator()}, {2, t.a.numerator()}}, t.budget);
    CHECK(t.equal(derivative_in_u(p, t), derivative(p, u)));
  }
}

TEST_CASE("derivatives in jets, sines and exponentials obey the product and quotient rules",
          "[law]") {
  Tools t;
  std::mt19937 random{91};
  for (int i = 0; i < 60; ++i) {
    t.with_finer_angles([&] {
      const Fraction x = t.random_value(random);
      const Fraction y = t.random_value(random);
      const Fraction dx = derivative_in_u(x, t);
      const Fraction dy = derivative_in_u(y, t);
      CHECK(t.equal(derivative_in_u(t.add(x, y), t), t.add(dx, dy)));
      const Fraction xy = t.in_normal_form(t.times(x, y));
      CHECK(t.equal(derivative_in_u(xy, t), t.add(t.times(dx, y), t.times(x, dy))));
      if (y.is_zero()) return;
      const Fraction upper = t.minus(t.times(dx, y), t.times(x, dy));
      CHECK(t.equal(derivative_in_u(t.over(x, y), t), t.over(upper, t.times(y, y))));
    });
  }
}

TEST_CASE("the chain rule: first replaced, then derived, or derived, replaced and multiplied",
          "[law]") {
  Tools t;
  std::mt19937 random{92};
  for (int i = 0; i < 60; ++i) {
    t.with_finer_angles([&] {
      const Fraction outer = t.random_value(random);
      const Fraction inner =
          t.add(t.times(Rational{random_small(random, 3)}, t.u),
                t.add(t.times(Rational{random_small(random, 2)}, t.times(t.u, t.u)),
                      t.times(Rational{random_small(random, 2)}, t.a)));
      const std::map<Variable, Fraction> images{{Tools::variable_of(t.u), inner}};
      const auto moved = [&](const Fraction& x) { return Substitution{images, t.workspace}(x); };
      // Not inside CHECK, which would catch FinerAngles.
      const bool agree =
          t.equal(derivative_in_u(moved(outer), t),
                  t.times(moved(derivative_in_u(outer, t)), derivative_in_u(inner, t)));
      INFO("inner " << words(inner));
      CHECK(agree);
    });
  }
}

TEST_CASE("replacing goes with sums and products, inside the arguments of jets as well", "[law]") {
  Tools t;
  std::mt19937 random{93};
  for (int i = 0; i < 60; ++i) {
    t.with_finer_angles([&] {
      const Fraction x = t.random_value(random);
      const Fraction y = t.random_value(random);
      const Fraction image = t.add(t.v, Rational{random_small(random, 2)});
      const std::map<Variable, Fraction> images{{Tools::variable_of(t.u), image}};
      const auto moved = [&](const Fraction& z) { return Substitution{images, t.workspace}(z); };
      const bool of_sum = t.equal(moved(t.add(x, y)), t.add(moved(x), moved(y)));
      const bool of_product =
          t.equal(moved(t.in_normal_form(t.times(x, y))), t.times(moved(x), moved(y)));
      CHECK(of_sum);
      CHECK(of_product);
    });
  }
}

TEST_CASE("f(u^2) has the second derivative 2 f'(u^2) + 4 u^2 f''(u^2)") {
  Tools t;
  const Fraction square = t.times(t.u, t.u);
  const Fraction twice = derivative_in_u(derivative_in_u(t.f(square), t), t);
  const Fraction expected = t.add(t.times(Rational{2}, t.f(square, 1)),
                                  t.times(Rational{4}, t.times(square, t.f(square, 2))));
  CHECK(t.equal(twice, expected));
  CHECK_FALSE(t.equal(twice, t.f(square, 2)));
}

TEST_CASE("what does not depend on the variable has derivative zero") {
  Tools t;
  for (const Fraction& value : {t.a, t.v, t.f(t.v), t.f(Fraction{Rational{1}}, 2), t.pi})
    CHECK(derivative_in_u(value, t).is_zero());
}

TEST_CASE("u and v are replaced at once") {
  Tools t;
  Substitution swap{{{Tools::variable_of(t.u), t.v}, {Tools::variable_of(t.v), t.u}}, t.workspace};
  const Fraction value = t.add(t.f(t.u), t.times(Rational{2}, t.f(t.v)));
  CHECK(t.equal(swap(value), t.add(t.f(t.v), t.times(Rational{2}, t.f(t.u)))));
}

TEST_CASE("the derivative of a root needs that the radicand does not vanish", "[law]") {
  Tools t;
  Conditions at_least_zero;
  const Fraction root = square_root(t.u, at_least_zero, t.workspace);
  REQUIRE(at_least_zero.size() == 1);
  CHECK(at_least_zero.begin()->kind == Condition::Kind::at_least_zero);
  Conditions conditions;
  const Fraction slope = derivative(root, Tools::variable_of(t.u), conditions, t.workspace);
  REQUIRE(conditions.size() == 1);
  CHECK(conditions.begin()->kind == Condition::Kind::not_zero);
  CHECK(conditions.begin()->polynomial == t.u.numerator());
  // 2 sqrt(u) sqrt(u)' == 1
  CHECK(t.equal(t.times(Rational{2}, t.times(root, slope)), Rational{1}));
}

TEST_CASE("derivatives that are not assumed to exist have no value", "[reject]") {
  Tools t;
  Conditions conditions;
  CHECK_THROWS_WITH(derivative(t.f(t.u, 6), Tools::variable_of(t.u), conditions, t.workspace),
                    "a derivative of order 7 of 'f', which is only assumed C^6");
  CHECK_NOTHROW(derivative(t.f(t.v, 6), Tools::variable_of(t.u), conditions, t.workspace));
}

}  // namespace patchproof
