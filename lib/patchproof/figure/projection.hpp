#pragma once

#include <patchproof/figure/sampled_function.hpp>

namespace patchproof {

/// Where space is looked at from, in whole degrees: the azimuth turns the x axis away from the
/// right, towards the viewer; the elevation is the height of the eye.
struct View {
  int azimuth = 32;
  int elevation = 30;
  friend bool operator==(const View&, const View&) = default;
};

/// A parallel projection of space: to the right, up, and towards the viewer.
class Projection {
 public:
  /// Orthographic; the directions are rounded to 2^-40.
  explicit Projection(const View& view);
  /// The plane as it is: x to the right, y up.
  static Projection flat();

  /// To the right, up, and how near.
  Point operator()(const Point& point) const;

  /// The direction in space that these steps to the right, up and towards the viewer add up to.
  Point direction(const Rational& right, const Rational& up, const Rational& near) const;
  const Point& towards_viewer() const { return near_; }

 private:
  Projection() = default;
  Point right_{1, 0, 0};
  Point up_{0, 1, 0};
  Point near_{0, 0, 1};
};

}  // namespace patchproof
