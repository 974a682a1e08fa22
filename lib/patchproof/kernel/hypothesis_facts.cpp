#include <patchproof/kernel/hypotheses.hpp>
#include <patchproof/kernel/integration_variables.hpp>

namespace patchproof {

void Hypotheses::add_ranges(const Goal& goal, Evaluator& evaluator) {
  for (const ParameterRange& range : goal.ranges) {
    const Variable v = workspace_.atoms.symbol(range.parameter);
    const Fraction low = evaluator.value(range.lower).components.front();
    const Fraction high = evaluator.value(range.upper).components.front();
    ranges_.insert_or_assign(v, Range{low, high});
    if (low.is_polynomial() && low.numerator().is_constant() && high.is_polynomial() &&
        high.numerator().is_constant())
      facts_.add_interval(v, {low.numerator().constant(), high.numerator().constant()});
  }
}

// Positive lengths are proper; so are those that vanish at single places only, as in v in [0, u]:
// polynomials in parameters, not negative and not zero, are positive almost everywhere.
void Hypotheses::require_proper_range(Variable parameter) const {
  const auto range = ranges_.find(parameter);
  if (range == ranges_.end()) return;
  const Polynomial length =
      difference(range->second.high, range->second.low, workspace_.budget).numerator();
  if (facts_.never_zero(length, workspace_.budget)) return;
  const std::set<Variable> named = length.variables();
  const bool almost_positive =
      !length.is_zero() && parameters_in(length) == named &&
      difference(range->second.high, range->second.low, workspace_.budget).is_polynomial() &&
      facts_.never_negative(length, workspace_.budget);
  if (!almost_positive)
    throw OutsideTheory{"the range of '" + workspace_.atoms[parameter].symbol->name +
                        "' may be a single point; assume that its ends differ"};
}

void Hypotheses::require_proper_ranges(const Polynomial& polynomial) const {
  for (const Variable v : parameters_in(polynomial)) require_proper_range(v);
}

bool Hypotheses::has_dependent_range(Variable parameter) const {
  const auto range = ranges_.find(parameter);
  if (range == ranges_.end()) return false;
  for (const Fraction& end : {range->second.low, range->second.high})
    for (const Polynomial& part : parts_of(end))
      if (!parameters_in(part).empty()) return true;
  return false;
}

void Hypotheses::require_unrestricted(const Polynomial& polynomial) const {
  for (const Variable v : parameters_in(polynomial))
    if (restricted_.contains(v))
      throw OutsideTheory{"an inequality restricts '" + workspace_.atoms[v].symbol->name +
                          "', so it is not clear for how many of its values the equations hold"};
}

void Hypotheses::find_restricted(const Goal& goal, const std::vector<bool>& enabled,
                                 Evaluator& evaluator) {
  for (std::size_t k = 0; k < goal.assumptions.size(); ++k) {
    const Statement& statement = goal.assumptions[k].statement;
    if (!enabled[k] || statement.relation == Relation::equal) continue;
    std::set<Variable> named;
    for (const Term& side : {statement.left, statement.right})
      for (const Fraction& component : evaluator.value(side).components) {
        named.merge(parameters_in(component.numerator()));
        for (const auto& [factor, exponent] : component.denominator())
          named.merge(parameters_in(factor));
      }
    if (statement.relation != Relation::not_equal) ordered_.insert(named.begin(), named.end());
    restricted_.merge(named);
  }
}

void Hypotheses::add_facts(const Goal& goal, const std::vector<bool>& enabled,
                           Evaluator& evaluator) {
  const auto add = [&](const Fraction& fraction, bool strict) {
    const Fraction simple = reduced(fraction);
    if (simple.is_polynomial()) facts_.add_inequality(simple.numerator(), strict);
  };
  for (const auto& [variable, range] : ranges_) {
    const Fraction parameter = Polynomial::variable(variable);
    add(difference(parameter, range.low, workspace_.budget), false);
    add(difference(range.high, parameter, workspace_.budget), false);
  }
  for (std::size_t k = 0; k < goal.assumptions.size(); ++k) {
    const Statement& statement = goal.assumptions[k].statement;
    if (!enabled[k] || statement.relation == Relation::equal) continue;
    const Value left = evaluator.value(statement.left);
    const Value right = evaluator.value(statement.right);
    conditions_.insert(left.conditions.begin(), left.conditions.end());
    conditions_.insert(right.conditions.begin(), right.conditions.end());
    const Fraction up =
        difference(left.components.front(), right.components.front(), workspace_.budget);
    const Fraction down =
        difference(right.components.front(), left.components.front(), workspace_.budget);
    switch (statement.relation) {
      case Relation::not_equal:
        // For points of known dimension only some component differs: nothing usable follows.
        if (left.components.size() == 1) facts_.add_not_zero(reduced(up).numerator());
        break;
      case Relation::greater:
      case Relation::greater_equal: add(up, statement.relation == Relation::greater); break;
      default: add(down, statement.relation == Relation::less); break;
    }
  }
}

}  // namespace patchproof
