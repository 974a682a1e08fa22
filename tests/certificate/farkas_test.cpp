#include <patchproof/certificate/farkas.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

namespace {

struct Linear {
  Budget budget{Limits{}};

  // a*x0 + b*x1 + c
  static Polynomial form(const Rational& a, const Rational& b, const Rational& c) {
    return Polynomial::from_terms({{Monomial{0}, a}, {Monomial{1}, b}, {Monomial{}, c}});
  }
  std::optional<std::vector<Rational>> factors(const std::vector<SignedPolynomial>& facts,
                                               const SignedPolynomial& goal) {
    return farkas_factors(facts, goal, budget);
  }
  // goal - sum of factors * facts
  Polynomial rest(const std::vector<SignedPolynomial>& facts, const Polynomial& goal,
                  const std::vector<Rational>& factors) {
    Polynomial result = goal;
    for (std::size_t k = 0; k < facts.size(); ++k)
      result = difference(result, scaled(facts[k].polynomial, factors[k]), budget);
    return result;
  }
};

}  // namespace

TEST_CASE("a positive combination of facts is found again, with a number left", "[law]") {
  std::mt19937 random{7};
  for (int i = 0; i < 200; ++i) {
    Linear linear;
    std::vector<SignedPolynomial> facts;
    Polynomial goal{Rational{static_cast<int>(random() % 3)}};
    for (int k = 0; k < 4; ++k) {
      const auto number = [&] { return Rational{static_cast<int>(random() % 7) - 3}; };
      facts.push_back({Linear::form(number(), number(), number()), false});
      goal = sum(goal, scaled(facts.back().polynomial, Rational{static_cast<int>(random() % 4)}),
                 linear.budget);
    }
    const auto found = linear.factors(facts, {goal, false});
    REQUIRE(found);
    const Polynomial rest = linear.rest(facts, goal, *found);
    REQUIRE(rest.is_constant());
    REQUIRE(rest.constant() >= 0);
    for (const Rational& factor : *found) REQUIRE(factor >= 0);
  }
}

TEST_CASE("what the facts do not imply has no factors") {
  Linear linear;
  const Polynomial u = Linear::form(1, 0, 0);
  CHECK_FALSE(linear.factors({{u, false}}, {Linear::form(-1, 0, 0), false}));
  CHECK_FALSE(linear.factors({{u, false}}, {Linear::form(0, 1, 0), false}));
  CHECK_FALSE(linear.factors({}, {u, false}));
}

TEST_CASE("only a strict fact or a number makes a strict goal") {
  Linear linear;
  const Polynomial u = Linear::form(1, 0, 0);
  CHECK_FALSE(linear.factors({{u, false}}, {u, true}));
  CHECK(linear.factors({{u, true}}, {u, true}));
  CHECK(linear.factors({{u, false}}, {Linear::form(1, 0, 1), true}));
}

TEST_CASE("facts that are not linear are left out") {
  Linear linear;
  const Polynomial square = product(Linear::form(1, 0, 0), Linear::form(1, 0, 0), linear.budget);
  CHECK_FALSE(linear.factors({{square, false}}, {square, false}));
}

}  // namespace patchproof
