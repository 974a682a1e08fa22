#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <patchproof/kernel/witness.hpp>

namespace patchproof {

/// Values given to variables, in the order they were chosen.
using Assignment = std::vector<std::pair<Variable, Rational>>;

/// Whether the variable may be given a value: a symbol, or an unknown function somewhere.
bool is_open(Variable variable, const Atoms& atoms);

/// The fraction with the variable set to the value, after all replacements of the hypotheses.
Fraction with_value(const Fraction& fraction, Variable variable, const Rational& value,
                    Hypotheses& hypotheses, Workspace& workspace);

/// Numbers, points and polynomials for everything the goal speaks of, as the assignment and the
/// hypotheses fix them; what they leave open is zero. Empty when they are not rational.
///
/// Functions go through their values at the variables before `known`, and at those assigned; later
/// ones belong to values that were tried and given up. Where values were chosen for functions under
/// integrals these get them at one place inside; in odd attempts another value at a second place, so
/// that the functions are less even and their integrals less likely to cancel.
std::optional<Witness> witness_values(const Goal& goal, const Assignment& assignment,
                                      Variable known, Hypotheses& hypotheses,
                                      Workspace& workspace, int attempt);

}  // namespace patchproof
