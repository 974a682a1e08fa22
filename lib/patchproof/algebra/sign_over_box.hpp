#pragma once

#include <map>

#include <patchproof/algebra/bernstein_form.hpp>

namespace patchproof {

/// How large the tree of boxes was on which a sign was decided.
struct Subdivision {
  std::size_t boxes = 0;  ///< its leaves
  unsigned depth = 0;     ///< the most cuts on the way to a leaf

  /// Adds another tree beside this one.
  void add(const Subdivision& other);
};

/// The answer to "is the polynomial nowhere negative on the box?", or, strictly, "positive there?".
struct BoxSign {
  enum class Answer {
    shown,  ///< yes: all Bernstein coefficients on all boxes of the tree say so
    fails,  ///< no: see `point`
    open,   ///< not decided by as many boxes as are looked at
  };
  Answer answer = Answer::open;
  Subdivision tree;
  /// fails: where the polynomial has the wrong sign; open: near where nothing was found out.
  std::map<Variable, Rational> point;
  /// The value at the point.
  Rational value;
};

/// The most boxes that are looked at for one question.
inline constexpr std::size_t most_boxes = 4096;

/// The most variables of a polynomial whose sign is asked for.
inline constexpr std::size_t most_box_variables = 6;

/// Decides the sign of a polynomial over a box by exact subdivision.
///
/// Only Bernstein coefficients and values make the answer. Where to cut is a heuristic: at the
/// middle, or where a zero was found, so that the zero becomes a corner. At a corner with a zero
/// the box is blown up (x = s, y = s*t, and with x and y exchanged; powers of s taken out), as
/// there no subdivision ends. A polynomial in one variable is decided, but for a zero at an
/// irrational place when the question is strict.
/// @throws std::out_of_range when a variable is not in the box; OverBudget
/// Source: Farin, Curves and Surfaces for CAGD, ch. 4 (de Casteljau) and ch. 5 (convex hull).
BoxSign sign_over_box(const Polynomial& polynomial, const Box& box, bool strict, Budget& budget);

}  // namespace patchproof
