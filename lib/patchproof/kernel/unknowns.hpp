#pragma once

#include <vector>

#include <patchproof/algebra/linear_system.hpp>
#include <patchproof/kernel/hypotheses.hpp>

namespace patchproof {

/// The unknowns of a system of equations, component by component, and how they are solved for.
struct UnknownSystem {
  std::vector<Variable> unknowns;
  LinearSolution solution;
  /// What the equations need to have a value, apart from the pivots.
  Conditions conditions;
};

/// Solves the equations of the goal for the given variables, for all values of the parameters.
///
/// Each equation must be linear in the unknowns; its coefficients with respect to the parameters,
/// and to everything that depends on a parameter, are set to zero one by one.
/// @throws OutsideTheory when an equation is not linear in the unknowns, or an unknown occurs in
/// the argument of a function.
UnknownSystem solved_system(const std::vector<Statement>& equations,
                            const std::vector<Variable>& unknowns, Evaluator& evaluator,
                            Hypotheses& hypotheses, Workspace& workspace);

}  // namespace patchproof
