// Zebra stripes: the patch reflects a ceiling of parallel dark and light strips. With the unit
// normal N = n/|n| and the direction d towards the viewer, the ray there comes from
// 2(d.N)N - d, so that its part in a fixed direction needs no root and is exact.
#include <algorithm>

#include <patchproof/figure/surface_parts.hpp>

namespace patchproof {

namespace {

/// A corner of a facet with the number that tells its strip: whole numbers are ends of strips.
struct Corner {
  Point point;
  Rational strip;
};

// The part of a convex polygon where the sign times (strip - at) is not negative.
std::vector<Corner> cut(const std::vector<Corner>& polygon, const Rational& at, int sign) {
  std::vector<Corner> result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Corner& a = polygon[k];
    const Corner& b = polygon[(k + 1) % polygon.size()];
    const Rational fa = sign * (a.strip - at);
    const Rational fb = sign * (b.strip - at);
    if (fa >= 0) result.push_back(a);
    if ((fa < 0 && fb > 0) || (fa > 0 && fb < 0)) {
      const Rational t = fa / (fa - fb);
      result.push_back({a.point + t * (b.point - a.point), at});
    }
  }
  return result;
}

long floor_of(const Rational& x) {
  const Integer whole = numerator(x) / denominator(x);
  return static_cast<long>(x < 0 && whole * denominator(x) != numerator(x) ? Integer{whole - 1}
                                                                           : whole);
}

class Zebra {
 public:
  Zebra(const Subject& patch, const Scene& scene)
      : patch_{patch},
        u_{patch.function.derivative({1, 0})},
        v_{patch.function.derivative({0, 1})},
        viewer_{scene.projection().towards_viewer()},
        across_{scene.projection().direction(1, {1, 4}, 0)} {}

  Rational strip(const std::vector<Rational>& place) const {
    constexpr int strips = 7;
    const Point n = normal(place);
    const Rational square = dot(n, n);
    if (square == 0) return 0;
    return strips * (2 * dot(viewer_, n) * dot(across_, n) / square - dot(viewer_, across_));
  }

 private:
  Point normal(const std::vector<Rational>& place) const {
    const Point a = u_.value(place);
    const Point b = v_.value(place);
    // The graph (u, v, f) has the normal (-f_u, -f_v, 1).
    if (patch_.is_graph) return {Rational{-a[0]}, Rational{-b[0]}, 1};
    return cross(a, b);
  }

  const Subject& patch_;
  SampledFunction u_;
  SampledFunction v_;
  Point viewer_;
  Point across_;
};

// Light all over, and the dark strips above that: so all edges of strips are those of dark ones.
void add_triangle(const std::vector<Corner>& corners, const Rational& lift, Scene& scene) {
  const auto points_of = [](const std::vector<Corner>& polygon) {
    std::vector<Point> points;
    for (const Corner& corner : polygon) points.push_back(corner.point);
    return points;
  };
  scene.add_facet(points_of(corners), Ink::stripe, 10);
  const auto [low, high] =
      std::minmax_element(corners.begin(), corners.end(),
                          [](const Corner& a, const Corner& b) { return a.strip < b.strip; });
  for (long k = floor_of(low->strip); Rational{k} <= high->strip; ++k) {
    if (k % 2 != 0) continue;
    const std::vector<Corner> strip = cut(cut(corners, k, 1), k + 1, -1);
    if (strip.size() >= 3) scene.add_facet(points_of(strip), Ink::stripe, 95, lift);
  }
}

}  // namespace

void add_zebra(const Subject& patch, const Grid& grid, Scene& scene) {
  const Zebra zebra{patch, scene};
  const Rational lift = lift_over(grid, scene.projection());
  const auto count = static_cast<long>(grid.cells);
  std::vector<Corner> corners;
  for (long i = 0; i <= count; ++i)
    for (long j = 0; j <= count; ++j)
      corners.push_back({grid.at(static_cast<std::size_t>(i), static_cast<std::size_t>(j)),
                         zebra.strip({Rational{i, count}, Rational{j, count}})});
  const auto at = [&](std::size_t i, std::size_t j) { return corners[i * (grid.cells + 1) + j]; };
  for (std::size_t i = 0; i < grid.cells; ++i)
    for (std::size_t j = 0; j < grid.cells; ++j) {
      add_triangle({at(i, j), at(i + 1, j), at(i + 1, j + 1)}, lift, scene);
      add_triangle({at(i, j), at(i + 1, j + 1), at(i, j + 1)}, lift, scene);
    }
}

}  // namespace patchproof
