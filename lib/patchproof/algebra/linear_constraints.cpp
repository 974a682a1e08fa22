#include <patchproof/algebra/linear_constraints.hpp>

#include <set>
#include <stdexcept>
#include <utility>

namespace patchproof {

namespace {

using Kind = LinearConstraint::Kind;
using Coefficients = std::map<unsigned, Rational>;

// Constraints by their coefficients, scaled so that the last of these is 1 or -1. Of parallel
// inequalities only the tightest is kept, of which there can be one; this is what keeps the
// elimination of dependent constraints from growing without need.
class ConstraintSet {
 public:
  // False when the constraint contradicts itself: it has no variables left and does not hold.
  bool add(LinearConstraint constraint, Budget& budget) {
    budget.spend(1 + constraint.coefficients.size());
    if (constraint.coefficients.empty()) return holds(constraint.constant, constraint.kind);
    const Rational scale = abs(constraint.coefficients.rbegin()->second);
    for (auto& [variable, coefficient] : constraint.coefficients) coefficient /= scale;
    const Rational constant = constraint.constant / scale;
    if (constraint.kind == Kind::zero) {
      equations_.push_back({std::move(constraint.coefficients), constant, Kind::zero});
      return true;
    }
    const auto [place, is_new] =
        bounds_.try_emplace(std::move(constraint.coefficients), Bound{constant, constraint.kind});
    Bound& bound = place->second;
    if (!is_new && (constant < bound.constant ||
                    (constant == bound.constant && constraint.kind == Kind::above_zero))) {
      bound = {constant, constraint.kind};
    }
    budget.require_terms(equations_.size() + bounds_.size());
    return true;
  }

  // Takes out all constraints whose last variable is this one. There is no later variable.
  std::vector<LinearConstraint> take(unsigned variable) {
    std::vector<LinearConstraint> taken;
    std::vector<LinearConstraint> others;
    for (LinearConstraint& equation : equations_) {
      const bool here = equation.coefficients.rbegin()->first == variable;
      (here ? taken : others).push_back(std::move(equation));
    }
    equations_ = std::move(others);
    for (auto place = bounds_.begin(); place != bounds_.end();) {
      if (place->first.rbegin()->first == variable) {
        taken.push_back({place->first, place->second.constant, place->second.kind});
        place = bounds_.erase(place);
      } else {
        ++place;
      }
    }
    return taken;
  }

  static bool holds(const Rational& value, Kind kind) {
    if (kind == Kind::zero) return value == 0;
    return kind == Kind::at_least_zero ? value >= 0 : value > 0;
  }

 private:
  struct Bound {
    Rational constant;
    Kind kind;
  };
  std::vector<LinearConstraint> equations_;
  std::map<Coefficients, Bound> bounds_;
};

// a + factor * b, without coefficients that vanish.
LinearConstraint combination(const LinearConstraint& a, const Rational& factor,
                             const LinearConstraint& b, Kind kind) {
  LinearConstraint result{a.coefficients, a.constant + factor * b.constant, kind};
  for (const auto& [variable, coefficient] : b.coefficients) {
    const auto place = result.coefficients.try_emplace(variable, 0).first;
    place->second += factor * coefficient;
    if (place->second == 0) result.coefficients.erase(place);
  }
  return result;
}

// What the constraints say of the other variables, exactly: these have values that satisfy the
// results if and only if they and some value of `variable` satisfy `constraints`. The last
// coefficients, those of `variable`, are 1 or -1. False when a contradiction appears.
bool eliminate(const std::vector<LinearConstraint>& constraints, ConstraintSet& rest,
               Budget& budget) {
  if (!constraints.empty() && constraints.front().kind == Kind::zero) {
    const LinearConstraint& equation = constraints.front();
    const Rational pivot = equation.coefficients.rbegin()->second;
    for (std::size_t i = 1; i < constraints.size(); ++i) {
      const LinearConstraint& other = constraints[i];
      budget.spend(other.coefficients.size() + equation.coefficients.size());
      const Rational factor = -other.coefficients.rbegin()->second / pivot;
      if (!rest.add(combination(other, factor, equation, other.kind), budget)) return false;
    }
    return true;
  }
  for (const LinearConstraint& lower : constraints) {
    if (lower.coefficients.rbegin()->second < 0) continue;
    for (const LinearConstraint& upper : constraints) {
      if (upper.coefficients.rbegin()->second > 0) continue;
      budget.spend(lower.coefficients.size() + upper.coefficients.size());
      const bool strict = lower.kind == Kind::above_zero || upper.kind == Kind::above_zero;
      const Kind kind = strict ? Kind::above_zero : Kind::at_least_zero;
      if (!rest.add(combination(lower, 1, upper, kind), budget)) return false;
    }
  }
  return true;
}

// The interval that constraints leave for their last variable, the others having values.
struct Interval {
  std::optional<Rational> low;
  bool low_strict = false;
  std::optional<Rational> high;
  bool high_strict = false;

  void raise(const Rational& bound, bool strict) {
    if (!low || bound > *low || (bound == *low && strict)) {
      low = bound;
      low_strict = strict;
    }
  }
  void lower(const Rational& bound, bool strict) {
    if (!high || bound < *high || (bound == *high && strict)) {
      high = bound;
      high_strict = strict;
    }
  }
};

// The left side at the values, leaving out variables that have none.
Rational value_of(const LinearConstraint& constraint, const std::map<unsigned, Rational>& values,
                  Budget& budget) {
  budget.spend(1 + constraint.coefficients.size());
  Rational sum = constraint.constant;
  for (const auto& [variable, coefficient] : constraint.coefficients) {
    const auto place = values.find(variable);
    if (place != values.end()) sum += coefficient * place->second;
  }
  return sum;
}

Rational simplest_value(const std::vector<LinearConstraint>& constraints,
                        const std::map<unsigned, Rational>& earlier, Budget& budget) {
  Interval interval;
  for (const LinearConstraint& constraint : constraints) {
    const Rational coefficient = constraint.coefficients.rbegin()->second;
    const Rational bound = -value_of(constraint, earlier, budget) / coefficient;
    const bool strict = constraint.kind == Kind::above_zero;
    if (constraint.kind == Kind::zero || coefficient > 0) interval.raise(bound, strict);
    if (constraint.kind == Kind::zero || coefficient < 0) interval.lower(bound, strict);
  }
  const std::optional<Rational> value =
      simplest_between(interval.low, interval.low_strict, interval.high, interval.high_strict);
  if (!value) throw std::logic_error{"elimination left an empty interval"};
  return *value;
}

}  // namespace

std::optional<std::map<unsigned, Rational>> small_model(
    const std::vector<LinearConstraint>& constraints, Budget& budget) {
  std::set<unsigned> variables;
  ConstraintSet rest;
  for (const LinearConstraint& constraint : constraints) {
    LinearConstraint clean{{}, constraint.constant, constraint.kind};
    for (const auto& [variable, coefficient] : constraint.coefficients) {
      variables.insert(variable);
      if (coefficient != 0) clean.coefficients.emplace(variable, coefficient);
    }
    if (!rest.add(std::move(clean), budget)) return std::nullopt;
  }
  // Last variables first, so that the values are found in ascending order.
  std::map<unsigned, std::vector<LinearConstraint>> eliminated;
  for (auto variable = variables.rbegin(); variable != variables.rend(); ++variable) {
    std::vector<LinearConstraint> here = rest.take(*variable);
    if (!eliminate(here, rest, budget)) return std::nullopt;
    eliminated.emplace(*variable, std::move(here));
  }
  std::map<unsigned, Rational> values;
  for (const auto& [variable, here] : eliminated) {
    values.emplace(variable, simplest_value(here, values, budget));
  }
  for (const LinearConstraint& constraint : constraints) {
    if (!ConstraintSet::holds(value_of(constraint, values, budget), constraint.kind)) {
      throw std::logic_error{"a model does not satisfy its constraints"};
    }
  }
  return values;
}

}  // namespace patchproof
