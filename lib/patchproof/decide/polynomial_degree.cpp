#include <patchproof/decide/polynomial_degree.hpp>

#include <algorithm>

#include <patchproof/decide/guard.hpp>
#include <patchproof/kernel/hypotheses.hpp>

namespace patchproof {

std::optional<unsigned> polynomial_degree(const Term& function, std::size_t parameter,
                                          const Limits& limits) {
  std::optional<unsigned> result;
  guarded(limits, [&](Workspace& workspace) {
    Evaluator evaluator{workspace};
    const Variable variable = evaluator.formals(function).at(parameter);
    unsigned degree = 0;
    bool polynomial = true;
    const auto free_of = [&](Variable other) {
      return !variables_within(Polynomial::variable(other), workspace.atoms).contains(variable);
    };
    for (const Fraction& component : evaluator.value(function).components) {
      for (const auto& [factor, exponent] : component.denominator())
        polynomial = polynomial && !variables_within(factor, workspace.atoms).contains(variable);
      for (const Variable other : component.numerator().variables())
        polynomial = polynomial && (other == variable || free_of(other));
      degree = std::max(degree, component.numerator().degree(variable));
    }
    if (polynomial) result = degree;
    return Decision{};
  });
  return result;
}

}  // namespace patchproof
