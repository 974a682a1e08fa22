#pragma once

#include <ginac/ginac.h>

#include <patchproof/symbolic/ring.hpp>

namespace patchproof::symbolic {

/// B_index^degree at t, by the recursion of de Casteljau; zero for an index outside 0..degree.
/// @throws OverBudget
GiNaC::ex bernstein(Ring& ring, int degree, int index, const GiNaC::ex& t);

/// The piece of N_{index,degree} on one knot span, as a polynomial in the local parameter t:
/// (k[i+p+1]-k[i]) times the divided difference of (y-x)_+^p over the knots k[i]..k[i+p+1].
///
/// @throws std::domain_error when the knots decrease, the span is empty, or an index is outside.
/// @throws OverBudget
/// Source: de Boor, A Practical Guide to Splines, IX (definition of B-splines).
GiNaC::ex bspline_piece(Ring& ring, const BasisFunction& basis, const GiNaC::ex& t);

}  // namespace patchproof::symbolic
