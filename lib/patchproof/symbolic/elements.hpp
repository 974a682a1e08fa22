#pragma once

#include <ginac/ginac.h>

#include <patchproof/symbolic/ring.hpp>

namespace patchproof::symbolic {

/// One component of a parameter, scalar, point or bound symbol.
GiNaC::ex letter(Ring& ring, const SymbolPointer& symbol, int component);

/// The formal parameter number `position` of a function that has no names for them.
GiNaC::ex placeholder(Ring& ring, int position);

/// One component of a derivative of an unknown function, at the arguments.
/// @throws OverBudget for an order of derivation that is too high.
GiNaC::ex jet(Ring& ring, const SymbolPointer& function, int component, const Indices& orders,
              const GiNaC::exvector& arguments);

/// The number pi.
GiNaC::ex pi(Ring& ring);

/// 1 / denominator, taken as defined unless the denominator is zero identically.
/// @throws std::domain_error when it is.
GiNaC::ex inverse(Ring& ring, const GiNaC::ex& denominator);

/// base^exponent for any whole exponent.
/// @throws std::domain_error for a negative power of zero.
GiNaC::ex whole_power(Ring& ring, const GiNaC::ex& base, long exponent);

/// The square root; one atom for each radicand, except that square factors of numbers go outside.
/// @throws std::domain_error for a negative number.
GiNaC::ex square_root(Ring& ring, const GiNaC::ex& radicand);

/// The argument as one that is already the argument of an atom and equal to it, if there is one.
GiNaC::ex canonical_argument(Ring& ring, const GiNaC::ex& argument);

}  // namespace patchproof::symbolic
