#pragma once

#include <map>

#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

/// Variables replaced at once, also inside the arguments of atoms: C1(u) with u -> 0 is C1(0).
///
/// Conditions that the new value needs (a root whose radicand changed) are added.
class Substitution {
 public:
  Substitution(std::map<Variable, Fraction> images, Workspace& workspace);

  Fraction operator()(const Fraction& fraction);
  Fraction operator()(const Polynomial& polynomial) { return (*this)(Fraction{polynomial}); }

  /// Conditions met so far on the way.
  const Conditions& conditions() const { return conditions_; }

 private:
  /// What the variable becomes; the variable itself when nothing in it changes.
  const Fraction& image(Variable variable);

  std::map<Variable, Fraction> images_;
  Workspace& workspace_;
  Conditions conditions_;
};

/// The total derivative with respect to one variable, all other symbols being constant: knows that
/// d C(a)/du is C'(a) da/du, and the derivatives of the elementary functions.
///
/// Conditions that the derivative needs (radicands not zero) are added.
/// @throws std::domain_error when a derivative is not assumed to exist.
Fraction derivative(const Fraction& fraction, Variable variable, Conditions& conditions,
                    Workspace& workspace);

}  // namespace patchproof
