#pragma once

#include <map>
#include <vector>

#include <patchproof/algebra/bernstein_form.hpp>

namespace patchproof {

/// The part of a box in which one coordinate, counted from a corner, is the largest, blown up to
/// the unit cube: x_k = s, and x_j = s * s_j for the others.
///
/// In these coordinates a polynomial that vanishes at the corner is a power of s times another one,
/// and only the other one's sign matters where s > 0.
class CornerChart {
 public:
  /// `corner` as for BernsteinForm::corner; `largest` is k.
  CornerChart(const BernsteinForm& form, unsigned corner, std::size_t largest, Budget& budget);

  /// What is left without the power of s, in variables 0, 1, …, one for each axis; s is `largest`.
  const Polynomial& polynomial() const { return polynomial_; }

  /// Where in the box, in its local coordinates, the sign of `polynomial` at the point shows. At
  /// s = 0 that is a place near the corner; the polynomial must not vanish at the point.
  std::vector<Rational> place(const std::map<Variable, Rational>& point, Budget& budget) const;

 private:
  unsigned corner_;
  std::size_t largest_;
  std::size_t dimension_;
  Polynomial polynomial_;
};

}  // namespace patchproof
