#pragma once

#include <patchproof/certificate/scalar.hpp>
#include <patchproof/term/term.hpp>

namespace patchproof {

/// A B-spline basis function on one knot span, written out by the recursion of Cox and de Boor in the
/// local parameter t, which runs from 0 to 1 over the span. Quotients 0/0 are left out.
/// Source: Piegl & Tiller, The NURBS Book, (2.5).
ScalarPointer spline_piece(const BasisFunction& function, const ScalarPointer& t);

}  // namespace patchproof
