#include <patchproof/kernel/sign_facts.hpp>

#include <algorithm>

namespace patchproof {

namespace {

constexpr std::size_t most_linear_constraints = 40;
constexpr unsigned most_bernstein_degree = 60;

// Power coefficients over [0,1] in one variable, turned into Bernstein coefficients:
// b_i = sum_{k<=i} C(i,k)/C(n,k) a_k. Source: Farin, ch. 5.
std::vector<Polynomial> bernstein_form(const std::vector<Polynomial>& powers, Budget& budget) {
  const std::size_t n = powers.size() - 1;
  std::vector<Polynomial> result;
  for (std::size_t i = 0; i <= n; ++i) {
    Polynomial total;
    Rational ratio = 1;
    for (std::size_t k = 0; k <= i; ++k) {
      total = sum(total, scaled(powers[k], ratio), budget);
      if (k < i) ratio *= Rational{i - k, n - k};
    }
    result.push_back(std::move(total));
  }
  return result;
}

// A sum of positive multiples of squares of monomials; strict: with a positive constant among them.
bool is_sum_of_squares(const Polynomial& polynomial, bool strict) {
  for (const auto& term : polynomial.terms()) {
    if (term.coefficient < 0) return false;
    for (const auto& p : term.monomial.powers())
      if (p.exponent % 2 == 1) return false;
  }
  return !strict || polynomial.constant() > 0;
}

// What is to be impossible for -p when p > 0 (strict) or p >= 0 is to be shown.
LinearConstraint::Kind opposite_of(bool strict) {
  return strict ? LinearConstraint::Kind::at_least_zero : LinearConstraint::Kind::above_zero;
}

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

bool SignFacts::positive_by_terms(const Polynomial& polynomial, bool strict,
                                  Budget& budget) const {
  for (const auto& term : polynomial.terms())
    if (term.coefficient < 0) return false;
  const std::set<Variable> variables = polynomial.variables();
  return std::all_of(variables.begin(), variables.end(), [&](Variable v) {
    return impossible(scaled(Polynomial::variable(v), -1), opposite_of(strict), budget);
  });
}

bool SignFacts::bernstein_positive(const Polynomial& polynomial, bool strict,
                                   Budget& budget) const {
  std::map<Variable, Polynomial> to_unit;
  std::vector<Polynomial> parts;
  const std::set<Variable> variables = polynomial.variables();
  // Variables without an interval stay in the coefficients, as the weights of a rational curve do.
  for (const Variable v : variables) {
    const auto found = intervals_.find(v);
    if (found == intervals_.end()) continue;
    if (polynomial.degree(v) > most_bernstein_degree) return false;
    const auto& [low, high] = found->second;
    to_unit.emplace(v, Polynomial::from_terms({{Monomial{}, low}, {Monomial{v}, high - low}}));
  }
  if (to_unit.empty()) return false;
  parts.push_back(substituted(polynomial, to_unit, budget));
  for (const auto& [v, affine] : to_unit) {
    std::vector<Polynomial> next;
    for (const Polynomial& part : parts) {
      std::vector<Polynomial> powers = coefficients(part, v);
      powers.resize(polynomial.degree(v) + 1);
      for (Polynomial& b : bernstein_form(powers, budget)) next.push_back(std::move(b));
    }
    parts = std::move(next);
    budget.require_terms(parts.size());
  }
  return std::all_of(parts.begin(), parts.end(), [&](const Polynomial& part) {
    if (part.is_constant()) return strict ? part.constant() > 0 : part.constant() >= 0;
    return impossible(scaled(part, -1), opposite_of(strict), budget) ||
           positive_by_terms(part, strict, budget);
  });
}

bool SignFacts::always_positive(const Polynomial& polynomial, Budget& budget) const {
  if (polynomial.is_constant()) return polynomial.constant() > 0;
  return is_sum_of_squares(polynomial, true) ||
         impossible(scaled(polynomial, -1), LinearConstraint::Kind::at_least_zero, budget) ||
         positive_by_terms(polynomial, true, budget) ||
         bernstein_positive(polynomial, true, budget);
}

bool SignFacts::never_negative(const Polynomial& polynomial, Budget& budget) const {
  if (polynomial.is_constant()) return polynomial.constant() >= 0;
  return is_sum_of_squares(polynomial, false) ||
         impossible(scaled(polynomial, -1), LinearConstraint::Kind::above_zero, budget) ||
         positive_by_terms(polynomial, false, budget) ||
         bernstein_positive(polynomial, false, budget);
}

bool SignFacts::never_zero(const Polynomial& polynomial, Budget& budget) const {
  if (polynomial.is_constant()) return !polynomial.is_zero();
  Polynomial rest = primitive(polynomial).polynomial;
  std::vector<Polynomial> factors = not_zero_;
  for (const Inequality& inequality : inequalities_)
    if (inequality.strict) factors.push_back(primitive(inequality.polynomial).polynomial);
  for (const Polynomial& factor : factors) {
    if (factor.is_constant()) continue;
    while (!rest.is_constant()) {
      const std::optional<Polynomial> shorter = quotient(rest, factor, budget);
      if (!shorter) break;
      rest = *shorter;
    }
  }
  if (rest.is_constant()) return true;
  return always_positive(rest, budget) || always_positive(scaled(rest, -1), budget) ||
         impossible(rest, LinearConstraint::Kind::zero, budget);
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
