#include <patchproof/kernel/elementary.hpp>
#include <patchproof/kernel/integral.hpp>
#include <patchproof/kernel/transformation.hpp>

namespace patchproof {

Substitution::Substitution(std::map<Variable, Fraction> images, Workspace& workspace)
    : images_{std::move(images)}, workspace_{workspace} {}

const Fraction& Substitution::image(Variable variable) {
  const auto known = images_.find(variable);
  if (known != images_.end()) return known->second;
  Atom atom = workspace_.atoms[variable];
  bool changed = false;
  for (Fraction& argument : atom.arguments) {
    const Fraction moved = (*this)(argument);
    if (moved < argument || argument < moved) {
      argument = moved;
      changed = true;
    }
  }
  Fraction result = Polynomial::variable(variable);
  if (changed) {
    switch (atom.kind) {
      case Atom::Kind::sine: result = sine(atom.arguments.front(), workspace_); break;
      case Atom::Kind::cosine: result = cosine(atom.arguments.front(), workspace_); break;
      case Atom::Kind::exponential: result = exponential(atom.arguments.front(), workspace_); break;
      case Atom::Kind::root:
        result = square_root(atom.arguments.front(), conditions_, workspace_);
        break;
      case Atom::Kind::integral: result = renewed_integral(atom, workspace_); break;
      default: result = Polynomial::variable(workspace_.atoms.variable(atom)); break;
    }
  }
  return images_.emplace(variable, std::move(result)).first->second;
}

Fraction Substitution::operator()(const Fraction& fraction) {
  std::map<Variable, Fraction> images;
  for (const Variable variable : variables(fraction)) {
    const Fraction& value = image(variable);
    if (!value.is_polynomial() || !(value.numerator() == Polynomial::variable(variable)))
      images.emplace(variable, value);
  }
  if (images.empty()) return fraction;
  return normal_form(substituted(fraction, images, workspace_.budget), workspace_);
}

}  // namespace patchproof
