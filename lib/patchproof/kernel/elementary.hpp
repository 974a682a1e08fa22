#pragma once

#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

/// sin, cos, exp and the square root of exact arguments, as fractions in atoms.
///
/// sin and cos of sums are expanded by the addition theorems; rational multiples of pi/12 have
/// their exact values; roots of rational numbers are products of roots of primes.
/// @throws FinerAngles when earlier values must be made again with a finer angle.
/// @throws OutsideTheory for arguments outside the theory (see the messages).
Fraction sine(const Fraction& angle, Workspace& workspace);
Fraction cosine(const Fraction& angle, Workspace& workspace);
Fraction exponential(const Fraction& exponent, Workspace& workspace);

/// Adds the condition that the radicand is not negative, unless it is a number.
/// @throws std::domain_error for a negative number.
Fraction square_root(const Fraction& radicand, Conditions& conditions, Workspace& workspace);

}  // namespace patchproof
