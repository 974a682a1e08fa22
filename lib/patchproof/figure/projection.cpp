#include <patchproof/figure/projection.hpp>

#include <patchproof/algebra/enclosure.hpp>
#include <patchproof/figure/decimal.hpp>

namespace patchproof {

namespace {

constexpr unsigned bits = 40;

Rational middle(const Enclosure& enclosure) {
  return rounded(Rational{(enclosure.low + enclosure.high) / 2}, bits);
}

Enclosure radians(int degrees) { return pi_enclosure(2 * bits) * exactly(Rational{degrees, 180}); }

}  // namespace

Projection::Projection(const View& view) {
  const Rational cos_a = middle(cosine(radians(view.azimuth), 2 * bits));
  const Rational sin_a = middle(sine(radians(view.azimuth), 2 * bits));
  const Rational cos_e = middle(cosine(radians(view.elevation), 2 * bits));
  const Rational sin_e = middle(sine(radians(view.elevation), 2 * bits));
  right_ = {cos_a, sin_a, 0};
  up_ = {Rational{-sin_a * sin_e}, Rational{cos_a * sin_e}, cos_e};
  near_ = {Rational{sin_a * cos_e}, Rational{-cos_a * cos_e}, sin_e};
}

Projection Projection::flat() { return {}; }

Point Projection::operator()(const Point& point) const {
  return {dot(right_, point), dot(up_, point), dot(near_, point)};
}

Point Projection::direction(const Rational& right, const Rational& up, const Rational& near) const {
  return right * right_ + up * up_ + near * near_;
}

}  // namespace patchproof
