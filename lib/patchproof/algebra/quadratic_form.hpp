#pragma once

#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/algebra/number.hpp>

namespace patchproof {

/// The signs a quadratic form x^T H x takes, with their proof.
struct QuadraticForm {
  enum class Kind {
    positive_definite,      ///< positive for all x != 0
    positive_semidefinite,  ///< never negative, but zero for some x != 0
    somewhere_negative,
  };
  Kind kind = Kind::positive_definite;
  /// The diagonal of D in L D L^T, in the order of elimination, as far as it went.
  std::vector<Rational> pivots;
  /// Somewhere negative: an x with x^T H x < 0.
  std::vector<Rational> negative_at;
};

/// Decides it by exact elimination; the matrix is symmetric.
/// Source: Golub & Van Loan, Matrix Computations, 4.1.
QuadraticForm quadratic_form(const std::vector<std::vector<Rational>>& matrix, Budget& budget);

}  // namespace patchproof
