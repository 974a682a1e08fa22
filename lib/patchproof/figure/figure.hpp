#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include <patchproof/algebra/number.hpp>

namespace patchproof {

/// A place in a figure, in millimetres from its lower left corner; y goes up. Exact: only writing
/// rounds.
struct Place {
  Rational x;
  Rational y;
  friend bool operator==(const Place&, const Place&) = default;
};

/// What something in a figure is; the table of inks says how it looks.
enum class Ink {
  surface,      ///< a facet of the side of a patch its normal points to
  back,         ///< a facet seen from its other side
  stripe,       ///< a dark zebra stripe
  isoline,      ///< a line of constant u or v
  boundary,     ///< an edge of a patch; a curve
  common,       ///< the edge two patches have in common
  wire,         ///< a line of constant u or v of a patch without facets
  net,          ///< a leg of a control net
  net_point,    ///< a control point
  twist,        ///< a twist vector
  other,        ///< the second of two functions that are compared
  other_curve,  ///< the same for a curve
  deviation,    ///< from the one to the other
  axis,         ///< an axis of coordinates
};

/// How an ink looks: one line of the table.
struct InkStyle {
  Ink ink;
  /// As colours are called in TikZ and classes in SVG, without prefix.
  std::string_view name;
  /// Red, green, blue; from 0 to 255.
  std::array<int, 3> colour;
  /// The width of lines and the radius of dots, in hundredths of a millimetre.
  int width;
};

/// All inks, in the order of the enumeration.
const std::vector<InkStyle>& inks();
const InkStyle& style_of(Ink ink);

/// A filled polygon without outline.
struct Polygon {
  std::vector<Place> corners;
  Ink ink = Ink::surface;
  /// How much of the colour there is, in percent; the rest is white.
  int strength = 100;
};

struct Polyline {
  std::vector<Place> places;
  Ink ink = Ink::boundary;
};

struct Arrow {
  Place from;
  Place to;
  Ink ink = Ink::twist;
};

struct Dot {
  Place at;
  Ink ink = Ink::net_point;
};

/// Which way a label stands off its place.
enum class Side { right, above_right, above, above_left, left, below_left, below, below_right };

/// The name of something: "V[0,3]", "C1", "r_uv(0,0)"; a writer makes mathematics of it.
struct Label {
  Place at;
  Side side = Side::above;
  std::string name;
};

using Shape = std::variant<Polygon, Polyline, Arrow, Dot, Label>;

/// A drawing: what comes later lies above what comes earlier.
struct Figure {
  /// In millimetres; all places lie inside, labels may stand out.
  Rational width;
  Rational height;
  std::vector<Shape> shapes;
  /// What a reader has to know that cannot be seen: sentences without a full stop, such as
  /// "V[i,j] are example points".
  std::vector<std::string> notes;
};

}  // namespace patchproof
