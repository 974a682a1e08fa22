#pragma once

#include <vector>

#include <patchproof/algebra/fraction.hpp>

namespace patchproof {

/// One linear equation: sum of coefficients[k] * unknown k == right.
struct LinearEquation {
  std::vector<Fraction> coefficients;
  Fraction right;
};

/// The solutions of a system of linear equations over fractions of polynomials.
struct LinearSolution {
  /// One entry for each unknown; unknowns in `free` stand for themselves, and values of others may
  /// contain them: value = constant part + sum over free of factors * unknown.
  std::vector<Fraction> constant_part;
  std::vector<std::vector<Fraction>> factors;  ///< [unknown][position in free]
  std::vector<std::size_t> free;
  /// Polynomials that were divided by: the solution holds where none of them vanishes.
  std::vector<Polynomial> pivots;
  /// What is left of an equation without unknowns: must be zero, and is not. Empty if none.
  std::vector<Fraction> contradictions;
};

/// Gauss-Jordan elimination. Rational pivots are preferred, so that conditions arise only when they
/// cannot be avoided; unknowns late in the order are left free before earlier ones.
LinearSolution solution(std::vector<LinearEquation> equations, std::size_t unknowns,
                        Budget& budget);

}  // namespace patchproof
