#include <patchproof/decide/minimum_search.hpp>

#include <algorithm>

#include <patchproof/decide/guard.hpp>
#include <patchproof/kernel/identity.hpp>
#include <patchproof/kernel/polynomial_term.hpp>
#include <patchproof/kernel/readable.hpp>
#include <patchproof/term/plain_text.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

[[noreturn]] void not_quadratic() {
  throw OutsideTheory{
      "the functional is not a polynomial of degree 2 in the control points of the competitor"};
}

}  // namespace

MinimumSearch::MinimumSearch(const MinimumGoal& goal, Workspace& workspace)
    : goal_{goal},
      workspace_{workspace},
      evaluator_{workspace, goal.goal.known},
      hypotheses_{goal.goal, std::vector<bool>(goal.goal.assumptions.size(), true), evaluator_,
                  workspace} {
  for (const SymbolPointer& symbol : goal.unknowns)
    for (std::size_t k = 0; k < symbol->type.component_count(); ++k)
      variables_.push_back(workspace.atoms.symbol(symbol, static_cast<int>(k)));
}

std::string MinimumSearch::set_up() {
  keep_open(hypotheses_.conditions(), hypotheses_, workspace_, {}, conditions_);
  if (std::string doubt = place_candidate(); !doubt.empty()) return doubt;
  if (std::string doubt = violated_constraint(); !doubt.empty()) return doubt;
  find_directions();
  expand();
  keep_open(hypotheses_.conditions(), hypotheses_, workspace_, {}, conditions_);
  return "";
}

namespace {

// "p == r on boundary", as it is written.
std::string written_text(const Statement& constraint) {
  const Span& span = constraint.span;
  if (!span.source) return to_text(constraint.left, 60) + " == " + to_text(constraint.right, 60);
  std::string text =
      span.source->text.substr(span.begin, std::min<std::size_t>(span.end - span.begin, 120));
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace

// Where nothing vanishes that was divided by, the solution is the only one.
void MinimumSearch::add_conditions(const UnknownSystem& system) {
  conditions_.insert(system.conditions.begin(), system.conditions.end());
  for (const Polynomial& pivot : system.solution.pivots)
    keep_open({{Condition::Kind::not_zero, pivot}}, hypotheses_, workspace_, {}, conditions_);
}

std::string MinimumSearch::place_candidate() {
  const UnknownSystem system =
      solved_system({goal_.membership}, variables_, evaluator_, hypotheses_, workspace_);
  if (!system.solution.contradictions.empty())
    return "the candidate is not among the competitors: no control points of theirs give it";
  add_conditions(system);
  // Control points that do not matter for the function are taken to be zero.
  candidate_ = system.solution.constant_part;
  for (const std::size_t k : system.solution.free) candidate_[k] = Fraction{};
  return "";
}

Fraction MinimumSearch::difference_of(const Statement& statement) {
  const std::vector<Fraction> left = evaluator_.value(statement.left).components;
  const std::vector<Fraction> right = evaluator_.value(statement.right).components;
  std::map<Variable, Fraction> images;
  for (std::size_t k = 0; k < variables_.size(); ++k) images.emplace(variables_[k], candidate_[k]);
  Substitution substitution{std::move(images), workspace_};
  for (std::size_t c = 0; c < left.size(); ++c) {
    const Fraction plain = difference(left[c], right[c], workspace_.budget);
    const Fraction d = normal_form(hypotheses_.reduced(substitution(plain)), workspace_);
    if (!d.is_zero()) return d;
  }
  return {};
}

std::string MinimumSearch::violated_constraint() {
  for (const Statement& constraint : goal_.constraints)
    if (!difference_of(constraint).is_zero())
      return "the candidate does not satisfy the constraint " + written_text(constraint);
  return "";
}

void MinimumSearch::find_directions() {
  const UnknownSystem system =
      solved_system(goal_.constraints, variables_, evaluator_, hypotheses_, workspace_);
  add_conditions(system);
  if (!system.solution.contradictions.empty())
    throw OutsideTheory{"the constraints can be satisfied only for special values of the symbols"};
  free_ = system.solution.free;
  directions_.assign(variables_.size(), std::vector<Rational>(free_.size()));
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    for (std::size_t f = 0; f < free_.size(); ++f) {
      if (free_[f] == k) directions_[k][f] = 1;
      if (std::find(free_.begin(), free_.end(), k) != free_.end()) continue;
      const Fraction& factor = system.solution.factors[k][f];
      if (!factor.is_polynomial() || !factor.numerator().is_constant())
        throw OutsideTheory{"the constraints have coefficients that are not numbers"};
      directions_[k][f] = factor.numerator().constant();
    }
  }
}

Fraction MinimumSearch::moved(std::size_t unknown) {
  Fraction result = candidate_[unknown];
  for (std::size_t f = 0; f < free_.size(); ++f)
    result =
        sum(result, scaled(Polynomial::variable(variables_[free_[f]]), directions_[unknown][f]),
            workspace_.budget);
  return result;
}

void MinimumSearch::expand() {
  const Statement& values = goal_.goal.statements.front();
  for (const Term& side : {values.left, values.right})
    keep_open(evaluator_.value(side).conditions, hypotheses_, workspace_, values.span, conditions_);
  const Fraction there = evaluator_.value(values.right).components.front();
  for (const auto& [factor, exponent] : there.denominator())
    for (const Variable v : variables_within(factor, workspace_.atoms))
      if (std::find(variables_.begin(), variables_.end(), v) != variables_.end()) not_quadratic();
  std::map<Variable, Fraction> images;
  for (std::size_t k = 0; k < variables_.size(); ++k) images.emplace(variables_[k], moved(k));
  const Fraction changed = Substitution{std::move(images), workspace_}(there);
  const Fraction here = evaluator_.value(values.left).components.front();
  const Fraction d =
      normal_form(hypotheses_.reduced(difference(changed, here, workspace_.budget)), workspace_);
  if (!d.is_polynomial())
    throw OutsideTheory{"the functional is divided by something that contains symbols"};
  difference_ = d.numerator();

  std::vector<std::vector<Polynomial::Term>> linear(free_.size());
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Polynomial::Term>> second;
  for (const auto& term : difference_.terms()) {
    workspace_.budget.spend(1 + free_.size());
    Monomial rest = term.monomial;
    std::vector<std::size_t> factors;
    for (const auto& p : term.monomial.powers()) {
      const auto found = std::find_if(free_.begin(), free_.end(),
                                      [&](std::size_t k) { return variables_[k] == p.variable; });
      if (found == free_.end()) {
        for (const Variable v :
             variables_within(Polynomial::variable(p.variable), workspace_.atoms))
          if (std::find(variables_.begin(), variables_.end(), v) != variables_.end())
            not_quadratic();
        continue;
      }
      if (p.exponent > 2) not_quadratic();
      factors.insert(factors.end(), p.exponent, static_cast<std::size_t>(found - free_.begin()));
      rest = rest.without(p.variable);
    }
    if (factors.size() > 2) not_quadratic();
    if (factors.empty())
      throw OutsideTheory{
          "the value of the functional at the candidate depends on how it is given"};
    if (factors.size() == 1)
      linear[factors[0]].push_back({rest, term.coefficient});
    else
      second[std::minmax(factors[0], factors[1])].push_back({rest, term.coefficient});
  }
  linear_.clear();
  for (auto& terms : linear) linear_.push_back(Polynomial::from_terms(std::move(terms)));
  second_.assign(free_.size(), std::vector<Polynomial>(free_.size()));
  for (auto& [place, terms] : second) {
    const auto [i, j] = place;
    const Polynomial coefficient = Polynomial::from_terms(std::move(terms));
    second_[i][j] = second_[j][i] = i == j ? scaled(coefficient, 2) : coefficient;
  }
}

std::optional<std::vector<std::vector<Rational>>> MinimumSearch::hessian() const {
  std::vector<std::vector<Rational>> result;
  for (const auto& row : second_) {
    result.emplace_back();
    for (const Polynomial& entry : row) {
      if (!entry.is_constant()) return std::nullopt;
      result.back().push_back(entry.constant());
    }
  }
  return result;
}

Polynomial MinimumSearch::symbolic_entry() const {
  for (const auto& row : second_)
    for (const Polynomial& entry : row)
      if (!entry.is_constant()) return entry;
  return {};
}

std::string MinimumSearch::direction_name(std::size_t f) const {
  return to_text(variables_[free_.at(f)], workspace_.atoms);
}

std::optional<std::vector<KnownValue>> MinimumSearch::better_competitor() {
  const auto second = hessian();
  if (!second) return std::nullopt;
  std::vector<Rational> y(free_.size());
  bool stationary = true;
  for (std::size_t f = 0; f < free_.size() && stationary; ++f) {
    if (!linear_[f].is_constant()) return std::nullopt;
    const Rational slope = linear_[f].constant();
    if (slope == 0) continue;
    stationary = false;
    // The least value of slope*y + curvature/2*y^2; where that is not bounded, any step down.
    const Rational curvature = (*second)[f][f];
    y[f] = curvature > 0 ? Rational{-slope / curvature} : Rational{slope > 0 ? -1 : 1};
  }
  if (stationary) {
    const QuadraticForm form = quadratic_form(*second, workspace_.budget);
    if (form.kind != QuadraticForm::Kind::somewhere_negative) return std::nullopt;
    y = form.negative_at;
  }
  std::vector<Fraction> coordinates = candidate_;
  for (std::size_t k = 0; k < variables_.size(); ++k)
    for (std::size_t f = 0; f < free_.size(); ++f)
      coordinates[k] =
          sum(coordinates[k], Fraction{Rational{directions_[k][f] * y[f]}}, workspace_.budget);
  return values(coordinates);
}

std::optional<std::vector<KnownValue>> MinimumSearch::values(
    const std::vector<Fraction>& coordinates) {
  std::vector<KnownValue> result;
  auto next = coordinates.begin();
  for (const SymbolPointer& symbol : goal_.unknowns) {
    const auto end = next + static_cast<std::ptrdiff_t>(symbol->type.component_count());
    const std::optional<Term> value =
        value_term(std::vector<Fraction>(next, end), symbol->type, workspace_.atoms);
    if (!value) return std::nullopt;
    result.push_back({symbol, *value});
    next = end;
  }
  return result;
}

Goal MinimumSearch::values_as_claim() {
  const Statement given = goal_.goal.statements.front();
  Goal result = goal_.goal;
  result.statements.clear();
  for (const Term& side : {given.left, given.right}) {
    const Fraction& value = evaluator_.value(side).components.front();
    result.statements.push_back(
        {side, Relation::equal, scalar_term(value, workspace_.atoms), given.span});
  }
  return result;
}

}  // namespace patchproof
