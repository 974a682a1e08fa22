#pragma once

#include <vector>

#include <patchproof/term/term.hpp>

namespace patchproof {

/// Coefficients of 1, t, t^2, … of the Bernstein polynomial B_index^degree(t); zero for an index
/// outside 0..degree. Source: Farin, Curves and Surfaces for CAGD, ch. 5.
std::vector<Rational> bernstein_coefficients(int degree, int index);

/// Coefficients of 1, t, t^2, … of a B-spline basis function on one knot span, t in [0,1] there.
/// Source: Piegl & Tiller, The NURBS Book, 2.2, the Cox-de Boor recursion with 0/0 = 0.
std::vector<Rational> basis_coefficients(const BasisFunction& function);

}  // namespace patchproof
