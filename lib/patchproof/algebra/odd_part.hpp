#pragma once

#include <patchproof/algebra/polynomial.hpp>

namespace patchproof {

/// The product of the factors that a polynomial in one variable has an odd number of times, each
/// once, with the sign of the polynomial wherever that is not zero.
///
/// (x - 1)^2 * (x^2 - 2)^3 becomes x^2 - 2, up to a positive factor.
/// @throws OverBudget; the numbers grow fast with the degree.
/// Source: von zur Gathen & Gerhard, Modern Computer Algebra, 14.6 (Yun's square-free
/// factorisation).
Polynomial odd_part(const Polynomial& polynomial, Variable variable, Budget& budget);

}  // namespace patchproof
