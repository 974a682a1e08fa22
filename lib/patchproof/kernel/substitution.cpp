#include <patchproof/kernel/elementary.hpp>
#include <patchproof/kernel/integral.hpp>
#include <patchproof/kernel/integration_variables.hpp>
#include <patchproof/kernel/transformation.hpp>

namespace patchproof {

namespace {

bool is_unchanged(Variable variable, const Fraction& image) {
  return image.is_polynomial() && image.numerator() == Polynomial::variable(variable);
}

// A variable of an integral that comes into another integral may meet the same name bound there: two
// integrals over one range call their variables alike.
void require_no_capture(Variable integral, const std::map<Variable, Fraction>& images,
                        const Atoms& atoms) {
  const std::set<Variable> inside = all_variables_within(Polynomial::variable(integral), atoms);
  for (const auto& [variable, image] : images) {
    if (!inside.contains(variable) || is_unchanged(variable, image)) continue;
    const std::set<Variable> before = free_running(Polynomial::variable(variable), atoms);
    for (const Polynomial& part : parts_of(image))
      for (const Variable v : free_running(part, atoms))
        if (!before.contains(v) || v == variable)
          throw OutsideTheory{"an integral inside another that depends on its variables is not "
                              "worked out in this version"};
  }
}

}  // namespace

Substitution::Substitution(std::map<Variable, Fraction> images, Workspace& workspace)
    : images_{std::move(images)}, workspace_{workspace} {}

const Fraction& Substitution::image(Variable variable) {
  const auto known = images_.find(variable);
  if (known != images_.end()) return known->second;
  Atom atom = workspace_.atoms[variable];
  if (atom.kind == Atom::Kind::integral)
    require_no_capture(variable, images_, workspace_.atoms);
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
    if (!is_unchanged(variable, value)) images.emplace(variable, value);
  }
  if (images.empty()) return fraction;
  return normal_form(substituted(fraction, images, workspace_.budget), workspace_);
}

}  // namespace patchproof
