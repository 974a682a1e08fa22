#pragma once

#include <optional>
#include <vector>

#include <patchproof/net/knot_vector.hpp>

namespace patchproof {

/// How two neighbouring spans are compared.
struct SeamPlan {
  /// Derivatives are compared up to this order: what was asked for, and what splines have.
  int order = 0;
  /// p - m: the order that splines have here.
  int given_order = 0;
  /// Of each order: what the difference of Bézier points before and behind the seam is multiplied
  /// by; the products are equal exactly when the derivatives are. Whole numbers.
  std::vector<Rational> before;
  std::vector<Rational> behind;
};

/// How a control point is calculated back from the Bézier points of a span.
struct ReturnPlan {
  std::size_t control_point = 0;
  /// p + 1 weights, over the denominator.
  std::vector<Rational> weights;
  Rational denominator{1};
};

struct SpanPlan {
  /// Its first control point.
  std::size_t first = 0;
  /// (p+1) * (p+1) weights over the denominator, see `bezier_weights`.
  std::vector<Rational> weights;
  Rational denominator{1};
  /// The control points that no span before has.
  std::vector<ReturnPlan> back;
};

/// All that is done in one direction, before any point is looked at.
struct DirectionPlan {
  int degree = 0;
  std::vector<SpanPlan> spans;
  /// Between the spans.
  std::vector<SeamPlan> seams;

  /// The largest sums of absolute weights of one point, of the way to the segments and back; the
  /// largest denominators; the largest factor of a comparison, with the sum of the binomial
  /// coefficients of its difference.
  Rational largest_weights() const;
  Rational largest_back_weights() const;
  Rational largest_denominator() const;
  Rational largest_back_denominator() const;
  Rational largest_comparison() const;
};

/// The plan for C^k, k = `continuity`: the weights are fractions, and all denominators 1.
DirectionPlan direction_plan(const KnotVector& knots, int continuity);

/// The same with weights that are whole numbers over the denominators. Empty when a denominator has
/// thousands of digits.
std::optional<DirectionPlan> whole_direction_plan(const KnotVector& knots, int continuity);

}  // namespace patchproof
