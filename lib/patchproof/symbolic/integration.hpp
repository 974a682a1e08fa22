#pragma once

#include <ginac/ginac.h>

#include <patchproof/symbolic/ring.hpp>

namespace patchproof::symbolic {

/// The integral of a polynomial in the atom `variable`, a letter or placeholder, which the bounds
/// do not contain.
/// @throws OverBudget
/// @throws std::domain_error when the variable occurs in other atoms or in a denominator.
GiNaC::ex integral(Ring& ring, const GiNaC::ex& integrand, unsigned variable,
                   const GiNaC::ex& lower, const GiNaC::ex& upper);

}  // namespace patchproof::symbolic
