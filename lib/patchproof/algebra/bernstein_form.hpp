#pragma once

#include <map>
#include <utility>
#include <vector>

#include <patchproof/algebra/polynomial.hpp>

namespace patchproof {

/// All numbers from `low` to `high`, the ends included.
struct Interval {
  Rational low;
  Rational high;
};

/// For each variable the interval it runs over.
using Box = std::map<Variable, Interval>;

/// A polynomial over a box by its Bernstein coefficients: a tensor with one axis for each variable
/// of the box, in their order.
///
/// The polynomial lies between the least and the greatest coefficient, and the coefficients at the
/// corners of the tensor are its values at the corners of the box.
/// Source: Farin, Curves and Surfaces for CAGD, ch. 5 and 16 (convex hull, end points).
class BernsteinForm {
 public:
  /// All variables of the polynomial have to be in the box.
  /// @throws std::out_of_range when one is not; OverBudget
  BernsteinForm(const Polynomial& polynomial, const Box& box, Budget& budget);

  std::size_t dimension() const { return degrees_.size(); }
  const std::vector<unsigned>& degrees() const { return degrees_; }

  /// The coefficients up to the common positive factor `scale`; the last axis changes fastest.
  const std::vector<Integer>& coefficients() const { return coefficients_; }
  const Rational& scale() const { return scale_; }

  /// Where the coefficient of a corner stands; bit k set means the upper end of axis k.
  std::size_t corner(unsigned bits) const;

  /// The same polynomial over the two parts of the box, cut where the axis is divided in the ratio
  /// at : 1 - at; 0 < at < 1. Source: de Casteljau's algorithm, Farin, ch. 4.
  std::pair<BernsteinForm, BernsteinForm> split(std::size_t axis, const Rational& at,
                                                Budget& budget) const;

  /// The value at a point given in local coordinates, from 0 to 1 along each axis.
  Rational value(const std::vector<Rational>& local, Budget& budget) const;

 private:
  BernsteinForm() = default;
  void shorten();

  std::vector<unsigned> degrees_;
  std::vector<Integer> coefficients_;
  Rational scale_ = 1;
};

/// How many Bernstein coefficients the polynomial has over a box of the variables of the box.
std::size_t bernstein_size(const Polynomial& polynomial, const Box& box);

}  // namespace patchproof
