#pragma once

#include <vector>

#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

/// One variable of an integral and the interval it runs over; the ends do not contain variables of
/// the same integral.
struct IntegrationRange {
  Variable variable;
  Fraction lower;
  Fraction upper;
};
using IntegrationRanges = std::vector<IntegrationRange>;

/// The integral of a continuous integrand over a rectangle, as far as it can be worked out:
/// polynomials by antiderivatives, derivatives of unknown functions by the fundamental theorem,
/// products of two of them by parts. What is left are atoms, one for each integrand.
/// @throws OutsideTheory when a divisor or a root depends on a variable of the integral.
Fraction integral(const Fraction& integrand, const IntegrationRanges& ranges, Workspace& workspace);

/// The variables of an atom that is an integral, and their ranges.
IntegrationRanges ranges_of(const Atom& integral, const Atoms& atoms);

/// The integral again after something in its integrand or its bounds has been replaced.
/// @throws OutsideTheory
Fraction renewed_integral(const Atom& integral, Workspace& workspace);

/// What must hold for an integral to have a value: the conditions of the integrand that do not
/// depend on its variables. The others have to hold on the whole rectangle.
/// @throws NoValue where one certainly fails, OutsideTheory where that was not settled.
Conditions conditions_outside(const Conditions& conditions, const IntegrationRanges& ranges,
                              const Span& span, Workspace& workspace);

}  // namespace patchproof
