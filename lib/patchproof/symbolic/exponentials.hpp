#pragma once

#include <ginac/ginac.h>

#include <patchproof/symbolic/ring.hpp>

namespace patchproof::symbolic {

/// exp(argument): a product of powers of one atom for each monomial of the argument.
/// @throws OverBudget
GiNaC::ex exponential(Ring& ring, const GiNaC::ex& argument);

/// (exp(i*argument) - exp(-i*argument)) / (2*i).
/// @throws OverBudget
GiNaC::ex sine(Ring& ring, const GiNaC::ex& argument);

/// (exp(i*argument) + exp(-i*argument)) / 2.
/// @throws OverBudget
GiNaC::ex cosine(Ring& ring, const GiNaC::ex& argument);

}  // namespace patchproof::symbolic
