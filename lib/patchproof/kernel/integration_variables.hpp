#pragma once

#include <patchproof/kernel/integral.hpp>

namespace patchproof {

/// Whether the value of the polynomial changes with a variable of the integral. Within other
/// integrals these variables are bound anew, and mean something else.
bool depends(const Polynomial& polynomial, const IntegrationRanges& ranges, const Atoms& atoms);

/// Checks that the factors, all of which depend on variables of an integral, are defined and
/// continuous everywhere: no roots, no divisions, no integrals in them.
/// @throws OutsideTheory
void require_plain(const Monomial& monomial, const Atoms& atoms);

}  // namespace patchproof
