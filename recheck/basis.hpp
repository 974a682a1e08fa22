#pragma once

#include <vector>

#include <recheck/number.hpp>

namespace recheck {

/// Coefficients of 1, t, t^2, ...
using Coefficients = std::vector<Rational>;

/// C(n,i) t^i (1-t)^(n-i).
Coefficients bernstein(std::size_t degree, std::size_t index);

/// The B-spline basis function N_{index,degree} over the knots, on the span from knots[span] to
/// knots[span+1], in t with x = (1-t)*knots[span] + t*knots[span+1].
///
/// There are knots up to index + degree + 1 and span + 1.
/// Source: Piegl & Tiller, The NURBS Book, 2.2 (Cox-de Boor recursion; 0/0 is 0).
Coefficients bspline_basis(std::size_t degree, std::size_t index, std::size_t span,
                           const std::vector<Rational>& knots);

}  // namespace recheck
