#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

namespace {

// What the square of the variable is; empty when it has no relation.
std::optional<Polynomial> square_of(Variable variable, Workspace& workspace) {
  const Atom atom = workspace.atoms[variable];
  if (atom.kind == Atom::Kind::root) return atom.arguments.front().numerator();
  if (atom.kind != Atom::Kind::sine) return std::nullopt;
  const Variable cosine = workspace.atoms.variable(
      {Atom::Kind::cosine, nullptr, 0, {}, atom.arguments});
  const Monomial square{cosine, 2};
  return Polynomial::from_terms({{Monomial{}, 1}, {square, -1}});
}

}  // namespace

Polynomial normal_form(const Polynomial& polynomial, Workspace& workspace) {
  if (!workspace.atoms.has_relations()) return polynomial;
  Polynomial result = polynomial;
  // Radicands may contain roots and sines themselves, but only of earlier atoms: going from the
  // latest variable to the first, none comes back.
  const std::set<Variable> variables = polynomial.variables();
  std::set<Variable, std::greater<>> waiting{variables.begin(), variables.end()};
  while (!waiting.empty()) {
    const Variable variable = *waiting.begin();
    waiting.erase(waiting.begin());
    if (result.degree(variable) < 2) continue;
    const std::optional<Polynomial> square = square_of(variable, workspace);
    if (!square) continue;
    for (const Variable v : square->variables())
      if (v < variable) waiting.insert(v);
    const std::vector<Polynomial> parts = coefficients(result, variable);
    Polynomial even;
    Polynomial odd;
    Polynomial factor{Rational{1}};
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (k > 0 && k % 2 == 0) factor = product(factor, *square, workspace.budget);
      Polynomial& target = k % 2 == 0 ? even : odd;
      target = sum(target, product(parts[k], factor, workspace.budget), workspace.budget);
    }
    result = sum(even, product(odd, Polynomial::variable(variable), workspace.budget),
                 workspace.budget);
  }
  return result;
}

Fraction normal_form(const Fraction& fraction, Workspace& workspace) {
  if (!workspace.atoms.has_relations()) return fraction;
  Fraction result{normal_form(fraction.numerator(), workspace)};
  for (const auto& [factor, exponent] : fraction.denominator()) {
    const Polynomial simple = normal_form(factor, workspace);
    if (simple.is_zero()) throw std::domain_error{"division by zero"};
    result = quotient(result, power(Fraction{simple}, static_cast<long>(exponent), workspace.budget),
                      workspace.budget);
  }
  return result;
}

}  // namespace patchproof
