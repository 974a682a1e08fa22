#pragma once

#include <ginac/ginac.h>

#include <patchproof/symbolic/ring.hpp>

namespace patchproof::symbolic {

/// The derivative of the polynomial, of some order, by an atom that is a letter or placeholder;
/// jets follow the chain rule.
/// @throws OverBudget
GiNaC::ex derivative(Ring& ring, const GiNaC::ex& polynomial, unsigned variable, int order);

}  // namespace patchproof::symbolic
