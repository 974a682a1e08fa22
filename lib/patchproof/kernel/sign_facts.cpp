#include <patchproof/kernel/sign_facts.hpp>

#include <algorithm>

namespace patchproof {

namespace {

constexpr std::size_t most_linear_constraints = 40;

}  // namespace

std::optional<LinearConstraint> linear_constraint(const Polynomial& polynomial,
                                                  LinearConstraint::Kind kind) {
  LinearConstraint result;
  result.kind = kind;
  for (const auto& term : polynomial.terms()) {
    if (term.monomial.total_degree() > 1) return std::nullopt;
    if (term.monomial.is_one())
      result.constant = term.coefficient;
    else
      result.coefficients[term.monomial.powers().front().variable] = term.coefficient;
  }
  return result;
}

void SignFacts::add_inequality(const Polynomial& polynomial, bool strict) {
  inequalities_.push_back({polynomial, strict});
}

void SignFacts::add_not_zero(const Polynomial& polynomial) {
  not_zero_.push_back(primitive(polynomial).polynomial);
}

void SignFacts::add_interval(Variable variable, const Interval& interval) {
  intervals_.insert_or_assign(variable, interval);
}

bool SignFacts::impossible(const Polynomial& polynomial, LinearConstraint::Kind kind,
                           Budget& budget) const {
  std::vector<LinearConstraint> system;
  const std::optional<LinearConstraint> extra = linear_constraint(polynomial, kind);
  if (!extra) return false;
  system.push_back(*extra);
  // Only what is connected with the polynomial by common variables can matter.
  std::set<Variable> reached = polynomial.variables();
  std::vector<bool> taken(inequalities_.size(), false);
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t k = 0; k < inequalities_.size(); ++k) {
      if (taken[k]) continue;
      const std::set<Variable> its = inequalities_[k].polynomial.variables();
      const bool touches = std::any_of(its.begin(), its.end(),
                                       [&](Variable v) { return reached.contains(v); });
      if (!touches) continue;
      const auto constraint = linear_constraint(
          inequalities_[k].polynomial, inequalities_[k].strict
                                           ? LinearConstraint::Kind::above_zero
                                           : LinearConstraint::Kind::at_least_zero);
      taken[k] = true;
      if (!constraint || system.size() >= most_linear_constraints) continue;
      system.push_back(*constraint);
      reached.insert(its.begin(), its.end());
      grown = true;
    }
  }
  return !small_model(system, budget).has_value();
}

bool SignFacts::always_positive(const Polynomial& polynomial, Budget& budget) const {
  return sign(polynomial, true, budget).shown();
}

bool SignFacts::never_negative(const Polynomial& polynomial, Budget& budget) const {
  return sign(polynomial, false, budget).shown();
}

bool SignFacts::never_zero(const Polynomial& polynomial, Budget& budget) const {
  return apart_from_zero(polynomial, budget).shown();
}

bool SignFacts::contradictory(Budget& budget) const {
  for (const Polynomial& polynomial : not_zero_)
    if (polynomial.is_zero()) return true;
  for (const Inequality& inequality : inequalities_) {
    const Polynomial& p = inequality.polynomial;
    if (p.is_constant() && (inequality.strict ? p.constant() <= 0 : p.constant() < 0)) return true;
    // The inequality is among the facts, so asking for it finds a contradiction around it.
    if (!p.is_constant() && impossible(p, inequality.strict ? LinearConstraint::Kind::above_zero
                                                            : LinearConstraint::Kind::at_least_zero,
                                       budget))
      return true;
  }
  // Something that must not vanish but has to, squeezed between inequalities.
  for (const Polynomial& p : not_zero_)
    if (impossible(p, LinearConstraint::Kind::above_zero, budget) &&
        impossible(scaled(p, -1), LinearConstraint::Kind::above_zero, budget))
      return true;
  return false;
}

}  // namespace patchproof
