#pragma once

#include <functional>
#include <optional>
#include <string>

#include <patchproof/net/knot_vector.hpp>
#include <patchproof/net/point_net.hpp>

namespace patchproof {

/// What the segments of a net are calculated with. All of it is exact.
enum class Arithmetic {
  words,         ///< whole numbers of 64 bits over a common denominator
  double_words,  ///< whole numbers of 128 bits over a common denominator
  fractions,     ///< fractions of any size
};

/// "words of 64 bits", "words of 128 bits", "fractions of any size"
std::string to_text(Arithmetic arithmetic);

/// The Bézier segments of one span in u and all spans in v.
class SegmentStrip {
 public:
  virtual ~SegmentStrip() = default;
  /// Coordinate c of the Bézier point (k, l) of the segment over span `number()` in u and span t in
  /// v; k belongs to u, from 0 to the degree.
  virtual Rational coordinate(std::size_t t, std::size_t k, std::size_t l, std::size_t c) const = 0;
  /// The span in u.
  virtual std::size_t number() const = 0;
};

/// Is shown one strip after the other, in the order of u, and may not keep it.
using StripSink = std::function<void(const SegmentStrip&)>;

/// Where two neighbouring segments have different one-sided derivatives.
struct SeamBreak {
  /// The spans in u and v of the first one; the second one is the next in the direction asked for.
  std::size_t u_span = 0;
  std::size_t v_span = 0;
  /// Of the derivative across the seam, with respect to the parameter of the spline.
  int order = 0;
  /// The derivative is a polynomial along the seam; which Bézier coefficient of it, and which of
  /// its coordinates.
  std::size_t coefficient = 0;
  std::size_t coordinate = 0;
  Rational before;
  Rational behind;
};

/// What was found out about the seams in one direction.
struct SeamFindings {
  /// Knot lines between spans; each of them is as many edges of segments as there are spans in the
  /// other direction.
  std::size_t seams = 0;
  std::size_t edges = 0;
  /// The order k for which C^k was asked.
  int order = 0;
  /// The least p - m among the seams, for the degree p and a knot that occurs m times: any net has
  /// this order. p where there is no seam.
  int given_order = 0;
  /// Edges where some derivative up to `order` is different.
  std::size_t broken_edges = 0;
  std::optional<SeamBreak> first_break;
};

/// The outcome of a conversion.
struct SegmentFindings {
  Arithmetic arithmetic = Arithmetic::words;
  /// Bits that are enough for every number on the way, with its sign; 0 when this was not found out
  /// because the common denominator alone is too large.
  std::size_t bits = 0;
  std::size_t u_spans = 0;
  std::size_t v_spans = 0;
  /// Whether the way to the segments is right for every net over these knots: see
  /// `holds_for_every_net`. Something else is a fault of the program.
  bool for_every_net = true;
  /// Whether the segments, as they were made, are the B-spline surface of the net: each of them
  /// joins the next one with the smoothness of splines over these knots, and the control points
  /// calculated from the segments are those of the net. Something else is a fault of the program.
  bool are_the_surface = true;
  /// Whether that was found out from the numbers of this net. It follows from the proof for every
  /// net alone where a large net needs fractions of any size.
  bool from_numbers = true;
  /// Control points without a span they belong to: the surface does not depend on them.
  std::size_t unused_points = 0;
  SeamFindings u;
  SeamFindings v;
};

/// Up to here nets of fractions of any size are looked at point by point.
inline constexpr std::size_t most_points_of_fractions = 10'000;

/// The Bézier segments of the B-spline surface with this net, strip by strip; each strip is proved
/// to be right and then shown to the sink, where there is one. Only two strips are in memory.
///
/// Nets of more than `most_points_of_fractions` points for which words are not enough are compared
/// only at those seams where splines do not have the continuity asked for; the rest follows from
/// the proof for every net.
///
/// C^k is decided for k = `continuity` across every seam: by the one-sided derivatives up to order
/// k, calculated from the Bézier points. Without `arithmetic` the fastest one is taken for which a
/// bound, calculated from the net and the knots before, shows that no number leaves its words.
/// @throws std::invalid_argument when the knots do not fit the net.
/// @throws std::overflow_error when the arithmetic asked for is not shown to be enough.
SegmentFindings segments_of(const PointNet& net, const KnotVector& u, const KnotVector& v,
                            int continuity, const StripSink& sink = {},
                            std::optional<Arithmetic> arithmetic = std::nullopt);

}  // namespace patchproof
