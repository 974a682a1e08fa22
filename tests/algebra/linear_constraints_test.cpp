#include <patchproof/algebra/linear_constraints.hpp>

#include <catch2/catch.hpp>
#include <random>
#include <string>

using patchproof::Budget;
using patchproof::Limits;
using patchproof::LinearConstraint;
using patchproof::Rational;
using patchproof::small_model;
using Kind = LinearConstraint::Kind;

namespace {

using Model = std::map<unsigned, Rational>;

std::string text(const std::vector<LinearConstraint>& constraints) {
  std::string result;
  for (const LinearConstraint& constraint : constraints) {
    for (const auto& [variable, coefficient] : constraint.coefficients) {
      result += patchproof::to_text(coefficient) + "*x" + std::to_string(variable) + " + ";
    }
    const char* const relation = constraint.kind == Kind::zero            ? " == 0"
                                 : constraint.kind == Kind::at_least_zero ? " >= 0"
                                                                          : " > 0";
    result += patchproof::to_text(constraint.constant) + relation + "\n";
  }
  return result;
}

Rational left_side(const LinearConstraint& constraint, const Model& model) {
  Rational sum = constraint.constant;
  for (const auto& [variable, coefficient] : constraint.coefficients) {
    sum += coefficient * model.at(variable);
  }
  return sum;
}

bool satisfies(const Model& model, const std::vector<LinearConstraint>& constraints) {
  for (const LinearConstraint& constraint : constraints) {
    const Rational value = left_side(constraint, model);
    if (constraint.kind == Kind::zero && value != 0) return false;
    if (constraint.kind == Kind::at_least_zero && value < 0) return false;
    if (constraint.kind == Kind::above_zero && value <= 0) return false;
  }
  return true;
}

int small(std::mt19937& random, int largest) {
  return static_cast<int>(random() % (2 * static_cast<unsigned>(largest) + 1)) - largest;
}

LinearConstraint random_constraint(std::mt19937& random, unsigned variables) {
  LinearConstraint constraint;
  for (unsigned variable = 0; variable < variables; ++variable) {
    if (random() % 3 != 0) constraint.coefficients[variable] = Rational{small(random, 4)};
  }
  constraint.constant = Rational{small(random, 6), 1 + static_cast<int>(random() % 2)};
  const unsigned kind = random() % 6;
  constraint.kind = kind == 0 ? Kind::zero : kind < 3 ? Kind::above_zero : Kind::at_least_zero;
  return constraint;
}

std::optional<Model> model_of(const std::vector<LinearConstraint>& constraints) {
  Budget budget{Limits{}};
  return small_model(constraints, budget);
}

}  // namespace

TEST_CASE("a model satisfies constraints that were built to hold at some point", "[law]") {
  std::mt19937 random{10};
  for (int i = 0; i < 300; ++i) {
    const unsigned variables = 1 + random() % 4;
    Model point;
    for (unsigned v = 0; v < variables; ++v) point[v] = Rational{small(random, 9), 2};
    std::vector<LinearConstraint> constraints;
    for (unsigned k = 0; k < 2 + random() % 7; ++k) {
      LinearConstraint constraint = random_constraint(random, variables);
      constraint.constant -= left_side(constraint, point);
      if (constraint.kind == Kind::zero) constraint.constant -= left_side(constraint, point);
      if (constraint.kind == Kind::at_least_zero && left_side(constraint, point) < 0) {
        constraint.constant -= left_side(constraint, point);
      }
      if (constraint.kind == Kind::above_zero && left_side(constraint, point) <= 0) {
        constraint.constant += 1 - left_side(constraint, point);
      }
      constraints.push_back(constraint);
    }
    INFO(text(constraints));
    REQUIRE(satisfies(point, constraints));
    const std::optional<Model> model = model_of(constraints);
    REQUIRE(model);
    CHECK(satisfies(*model, constraints));
  }
}

TEST_CASE("constraints whose sum is a contradiction have no model", "[law]") {
  std::mt19937 random{11};
  for (int i = 0; i < 300; ++i) {
    const unsigned variables = 1 + random() % 4;
    std::vector<LinearConstraint> constraints;
    // The last one is minus a combination of the others with positive weights, and a constant
    // such that the whole sum says 0 > 0 or 0 >= something positive.
    LinearConstraint last;
    bool strict = false;
    for (unsigned k = 0; k < 1 + random() % 4; ++k) {
      LinearConstraint constraint = random_constraint(random, variables);
      const Rational weight = constraint.kind == Kind::zero ? Rational{1 + small(random, 3), 2}
                                                            : Rational(1 + random() % 5, 3);
      for (const auto& [variable, coefficient] : constraint.coefficients) {
        last.coefficients[variable] -= weight * coefficient;
      }
      last.constant -= weight * constraint.constant;
      strict = strict || constraint.kind == Kind::above_zero;
      constraints.push_back(constraint);
    }
    last.kind = strict || random() % 2 == 0 ? Kind::at_least_zero : Kind::above_zero;
    if (last.kind == Kind::at_least_zero && !strict) last.constant -= Rational(1, 1000);
    constraints.insert(
        constraints.begin() + static_cast<std::ptrdiff_t>(random() % (constraints.size() + 1)),
        last);
    INFO(text(constraints));
    CHECK_FALSE(model_of(constraints));
  }
}

TEST_CASE("whether there is a model agrees with trying a fine grid", "[law]") {
  std::mt19937 random{12};
  int with_model = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<LinearConstraint> constraints;
    for (unsigned k = 0; k < 3 + random() % 4; ++k) {
      constraints.push_back(random_constraint(random, 2));
    }
    const std::optional<Model> model = model_of(constraints);
    INFO(text(constraints));
    if (model) {
      ++with_model;
      Model complete = *model;
      complete.merge(Model{{0, 0}, {1, 0}});
      CHECK(satisfies(complete, constraints));
      continue;
    }
    for (int x = -12; x <= 12; ++x) {
      for (int y = -12; y <= 12; ++y) {
        REQUIRE_FALSE(satisfies({{0, Rational{x, 3}}, {1, Rational{y, 3}}}, constraints));
      }
    }
  }
  CHECK(with_model > 20);
  CHECK(with_model < 180);
}

TEST_CASE("strictness decides: x >= 0 and -x >= 0 meet in zero, x > 0 and -x >= 0 do not") {
  const LinearConstraint up{{{0, 1}}, 0, Kind::at_least_zero};
  const LinearConstraint down{{{0, -1}}, 0, Kind::at_least_zero};
  const LinearConstraint strictly_up{{{0, 1}}, 0, Kind::above_zero};
  CHECK(model_of({up, down}) == Model{{0, 0}});
  CHECK_FALSE(model_of({strictly_up, down}));
  CHECK_FALSE(model_of({down, strictly_up}));
}

TEST_CASE("parallel bounds keep the tightest of them") {
  for (const bool strict_first : {false, true}) {
    const LinearConstraint weak{{{0, 1}, {1, 1}}, -1, Kind::at_least_zero};
    const LinearConstraint strong{{{0, 2}, {1, 2}}, -2, Kind::above_zero};
    const LinearConstraint end{{{0, -1}, {1, -1}}, 1, Kind::at_least_zero};
    CHECK_FALSE(
        model_of(strict_first ? std::vector{strong, weak, end} : std::vector{weak, strong, end}));
  }
  CHECK(model_of({{{{0, 1}}, -3, Kind::at_least_zero}, {{{0, 1}}, -7, Kind::at_least_zero}}) ==
        Model{{0, 7}});
  CHECK(model_of({{{{0, 1}}, -7, Kind::at_least_zero}, {{{0, 1}}, -3, Kind::at_least_zero}}) ==
        Model{{0, 7}});
}

TEST_CASE("a model has the simplest values, the first variables first") {
  CHECK(model_of({}) == Model{});
  CHECK(model_of({{{{3, 0}}, 0, Kind::zero}}) == Model{{3, 0}});
  // x + y == 1
  CHECK(model_of({{{{0, 1}, {1, 1}}, -1, Kind::zero}}) == Model{{0, 0}, {1, 1}});
  // 0 < x < 1, y > x
  CHECK(model_of({{{{0, 1}}, 0, Kind::above_zero},
                  {{{0, -1}}, 1, Kind::above_zero},
                  {{{0, -1}, {1, 1}}, 0, Kind::above_zero}}) == Model{{0, Rational(1, 2)}, {1, 1}});
  // 3 x == 2 and y == 2 x
  CHECK(model_of({{{{5, 3}}, -2, Kind::zero}, {{{5, -2}, {9, 1}}, 0, Kind::zero}}) ==
        Model{{5, Rational(2, 3)}, {9, Rational(4, 3)}});
}

TEST_CASE("constraints without variables hold or contradict", "[reject]") {
  CHECK(model_of({{{}, 0, Kind::zero}, {{}, 0, Kind::at_least_zero}, {{}, 1, Kind::above_zero}}));
  CHECK_FALSE(model_of({{{}, 1, Kind::zero}}));
  CHECK_FALSE(model_of({{{}, -1, Kind::at_least_zero}}));
  CHECK_FALSE(model_of({{{{0, 0}}, 0, Kind::above_zero}}));
}

TEST_CASE("an elimination that grows too large runs over its budget", "[reject]") {
  std::mt19937 random{13};
  std::vector<LinearConstraint> constraints;
  for (int k = 0; k < 80; ++k) {
    LinearConstraint constraint;
    for (unsigned v = 0; v < 12; ++v) constraint.coefficients[v] = Rational{small(random, 99)};
    constraint.constant = 1;
    constraint.kind = Kind::at_least_zero;
    constraints.push_back(constraint);
  }
  Limits limits;
  limits.terms = 2000;
  Budget few_terms{limits};
  CHECK_THROWS_AS(small_model(constraints, few_terms), patchproof::OverBudget);
  limits.terms = 0;
  limits.steps = 100'000;
  Budget few_steps{limits};
  CHECK_THROWS_AS(small_model(constraints, few_steps), patchproof::OverBudget);
}
