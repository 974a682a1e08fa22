#include <patchproof/kernel/evaluator.hpp>
#include <patchproof/kernel/integral.hpp>

namespace patchproof {

Value Evaluator::of_integral(const Term& term) {
  const Value integrand = value(term.child(0));
  const std::vector<Variable> parameters = formals(term.child(0));
  Value result;
  IntegrationRanges ranges;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const Value lower = value(term.child(2 * k + 1));
    const Value upper = value(term.child(2 * k + 2));
    for (const Value& end : {lower, upper})
      result.conditions.insert(end.conditions.begin(), end.conditions.end());
    ranges.push_back({parameters[k], lower.components.front(), upper.components.front()});
  }
  const Conditions outside =
      conditions_outside(integrand.conditions, ranges, term.span(), workspace_);
  result.conditions.insert(outside.begin(), outside.end());
  for (const Fraction& component : integrand.components)
    result.components.push_back(integral(component, ranges, workspace_));
  return result;
}

}  // namespace patchproof
