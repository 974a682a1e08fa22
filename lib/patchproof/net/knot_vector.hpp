#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <patchproof/algebra/rational.hpp>

namespace patchproof {

/// Thrown for a list of numbers that is no knot vector of such splines, with the reason.
class KnotFault : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The largest degree of a net that is converted to Bézier segments.
inline constexpr int highest_net_degree = 9;

/// The degree p and the knots t[0] <= … <= t[n+p] of the B-splines N[0], …, N[n-1] in one
/// direction. They are defined from t[p] to t[n]; the intervals of positive length in there are the
/// spans, each of which has a Bézier segment. Source: Piegl and Tiller, The NURBS Book,
/// section 2.2.
class KnotVector {
 public:
  /// For n control points. @throws KnotFault when the degree is not from 1 to `highest_net_degree`,
  /// there are not n > p points and n + p + 1 knots, the knots decrease, a knot occurs more than
  /// p + 1 times, or there is no span.
  KnotVector(int degree, std::vector<Rational> knots, std::size_t points);

  /// 0, …, 0, 1, 2, …, n - p, …, n - p with p + 1 equal knots at both ends.
  /// @throws KnotFault
  static KnotVector clamped_uniform(int degree, std::size_t points);

  int degree() const { return degree_; }
  std::size_t points() const { return knots_.size() - static_cast<std::size_t>(degree_) - 1; }
  const std::vector<Rational>& knots() const { return knots_; }
  /// How many spans there are.
  std::size_t spans() const { return spans_.size(); }
  /// The number k of the knots of a span, [t[k], t[k+1]]. Its control points are k - p, …, k.
  std::size_t knot_of_span(std::size_t span) const { return spans_[span]; }
  const Rational& begin_of(std::size_t span) const { return knots_[spans_[span]]; }
  const Rational& end_of(std::size_t span) const { return knots_[spans_[span] + 1]; }
  Rational length_of(std::size_t span) const { return end_of(span) - begin_of(span); }
  /// How often the knot occurs between this span and the next one, from 1 to p + 1. Splines are
  /// C^(p - m) there, where it occurs m times.
  int multiplicity_behind(std::size_t span) const {
    return static_cast<int>(spans_[span + 1] - spans_[span]);
  }

 private:
  int degree_;
  std::vector<Rational> knots_;
  std::vector<std::size_t> spans_;
};

}  // namespace patchproof
