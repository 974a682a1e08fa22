#pragma once

#include <string>
#include <vector>

#include <patchproof/figure/figure.hpp>
#include <patchproof/figure/projection.hpp>

namespace patchproof {

/// Things in space that become a figure: what is farther away is painted first.
class Scene {
 public:
  explicit Scene(const Projection& projection) : projection_{projection} {}

  const Projection& projection() const { return projection_; }

  /// A small polygon. `lift` is how much nearer it counts than it is.
  void add_facet(const std::vector<Point>& corners, Ink ink, int strength,
                 const Rational& lift = 0);
  /// A short segment on a surface or beside it, lifted so that the facets it lies on do not hide
  /// it.
  void add_segment(const Point& from, const Point& to, Ink ink, const Rational& lift);
  /// The rest is never hidden.
  void add_line(const std::vector<Point>& places, Ink ink);
  void add_arrow(const Point& from, const Point& to, Ink ink);
  void add_dot(const Point& at, Ink ink);
  /// The label stands off to the side that points away from `centre`.
  void add_label(const Point& at, const Point& centre, const std::string& name);

  /// All that was added, as wide as said in millimetres; where that would be higher than
  /// `greatest_height`, smaller.
  Figure figure(const Rational& width, const Rational& greatest_height) const;

 private:
  /// A shape before it is painted, with the lower number first among equally near ones.
  struct Item {
    int layer = 0;
    Rational depth;
    Shape shape;
  };
  Place place(const Point& point) const;

  Projection projection_;
  std::vector<Item> items_;
};

}  // namespace patchproof
