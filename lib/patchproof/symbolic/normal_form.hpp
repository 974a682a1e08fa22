#pragma once

#include <ginac/ginac.h>

#include <patchproof/symbolic/ring.hpp>

namespace patchproof::symbolic {

/// The polynomial times its denominators, with the relations between exponentials of multiples of
/// one monomial, and between roots of unity, used up. Zero only if the polynomial is zero.
/// @throws OverBudget
GiNaC::ex normal_form(Ring& ring, const GiNaC::ex& polynomial);

/// Whether the normal form is zero.
/// @throws OverBudget
bool is_zero(Ring& ring, const GiNaC::ex& polynomial);

/// Whether a normal form that is not zero is one of a number or function that is not zero. False
/// where relations between its atoms may exist that this engine does not know.
/// @throws OverBudget
bool is_surely_not_zero(Ring& ring, const GiNaC::ex& normal_form);

}  // namespace patchproof::symbolic
