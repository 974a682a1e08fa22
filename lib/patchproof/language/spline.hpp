#pragma once

#include <patchproof/language/blossom.hpp>

namespace patchproof {

class Elaborator;

/// Splines of higher degrees are rejected.
inline constexpr int highest_spline_degree = 40;

/// A B-spline curve or tensor product surface: control points, degrees, knots, one per direction.
/// With weights it is rational: the quotient of the splines of weight * point and of weight.
struct Spline {
  Term control_points;  ///< a list (curve) or a matrix (surface)
  Term weights;         ///< scalars in the same shape; empty when the spline is polynomial
  std::vector<int> degrees;
  std::vector<Knots> knots;

  /// 1 for a curve, 2 for a surface.
  std::size_t directions() const { return degrees.size(); }
  /// How many control points lie in this direction.
  int extent(std::size_t direction) const {
    const Type& type = control_points.type();
    return direction == 0 ? type.rows : type.columns;
  }
};

/// Rows of factors: one row for each new point, one factor for each old one.
using Factors = std::vector<std::vector<Term>>;

/// The control points of a spline while they are converted; homogeneous when there are weights.
/// Source: Piegl & Tiller, The NURBS Book, 4.2.
class ControlNet {
 public:
  /// The points of the spline, times their weights when it has any.
  ControlNet(const Spline& spline, Elaborator& elaborator, const Span& span);

  /// Each point becomes a combination of those in its row or column.
  void combine(std::size_t direction, const Factors& factors);

  /// Points and weights in the shape they have in a spline; Fault for a weight that is 0.
  Term points();
  /// Empty when there are none.
  Term weights();

 private:
  Term shaped(std::vector<std::vector<Term>> entries);

  Elaborator& elaborator_;
  KnotArithmetic arithmetic_;
  Span span_;
  bool list_ = false;
  bool changed_ = false;
  Term given_;
  std::vector<std::vector<Term>> points_;
  std::vector<std::vector<Term>> weights_;
};

/// The factors that turn the control points of one direction into Bézier points of all pieces,
/// neighbours sharing a point. Fault when the spline has a gap.
Factors bezier_factors(const Knots& knots, int degree, Elaborator& elaborator, const Span& span);

/// The factors that turn Bézier points of all pieces into control points: the blossom of one piece
/// at neighbouring knots.
Factors control_factors(const Knots& knots, int degree, Elaborator& elaborator, const Span& span);

/// The piece whose blossom gives control point i: it lies under the basis function and has as many
/// ends as possible among the knots i+1, …, i+degree; the first of those. `values` are numbers of
/// the knots' values, `starts` those of the pieces' first knots.
std::size_t piece_for_point(const std::vector<int>& values, const std::vector<int>& starts,
                            int degree, int i);

}  // namespace patchproof
