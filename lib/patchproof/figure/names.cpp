// Names of what can be told apart in a figure: control points at the corners, boundary curves.
#include <algorithm>

#include <patchproof/figure/surface_parts.hpp>

namespace patchproof {

namespace {

// The edges of a grid, by the places of their ends.
struct Edge {
  std::array<int, 2> from;
  std::array<int, 2> to;
};

const std::vector<Edge>& edges() {
  static const std::vector<Edge> all{
      {{0, 0}, {1, 0}}, {{0, 1}, {1, 1}}, {{0, 0}, {0, 1}}, {{1, 0}, {1, 1}}};
  return all;
}

std::vector<Rational> place_on(const Edge& edge, const Rational& t) {
  std::vector<Rational> result;
  for (std::size_t k = 0; k < 2; ++k)
    result.push_back(edge.from[k] + t * (edge.to[k] - edge.from[k]));
  return result;
}

// Five places are enough: nothing is concluded from a label.
bool runs_along(const Subject& curve, const Subject& patch, const Edge& edge) {
  if (curve.function.parameter_count() != 1) return false;
  for (int k = 0; k <= 4; ++k) {
    const Rational t{k, 4};
    if (curve.at({t}) != patch.at(place_on(edge, t))) return false;
  }
  return true;
}

bool contains(const std::vector<Point>& points, const Point& point) {
  return std::find(points.begin(), points.end(), point) != points.end();
}

}  // namespace

void add_names(const Subject& patch, const Grid& grid, Studio& studio, Scene& scene) {
  // A label stands off to where its corner or edge is seen from a place a little inside.
  const auto inside = [&](const std::vector<Rational>& place) {
    std::vector<Rational> nearer;
    for (const Rational& p : place) nearer.push_back(p + Rational{1, 8} * (Rational{1, 2} - p));
    return patch.at(nearer);
  };
  std::vector<Point> named_corners;
  bool any = false;
  const std::vector<NamedPoint> points = studio.named_points();
  for (const int i : {0, 1})
    for (const int j : {0, 1}) {
      const Point corner = grid.at(i == 0 ? 0 : grid.cells, j == 0 ? 0 : grid.cells);
      const auto named = std::find_if(points.begin(), points.end(),
                                      [&](const NamedPoint& p) { return p.point == corner; });
      // A triangle has two corners in one point.
      if (named == points.end() || contains(named_corners, corner)) continue;
      named_corners.push_back(corner);
      scene.add_label(corner, inside({Rational{i}, Rational{j}}), named->name);
      any = true;
    }
  const std::vector<Subject> curves = studio.named_curves();
  for (const Edge& edge : edges()) {
    const auto named = std::find_if(curves.begin(), curves.end(), [&](const Subject& curve) {
      return runs_along(curve, patch, edge);
    });
    if (named == curves.end()) continue;
    const std::vector<Rational> middle = place_on(edge, {1, 2});
    scene.add_label(patch.at(middle), inside(middle), named->name);
    any = true;
  }
  if (any) return;
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      scene.add_label(grid.at(i == 0 ? 0 : grid.cells, j == 0 ? 0 : grid.cells),
                      inside({Rational{i}, Rational{j}}),
                      patch.name + "(" + std::to_string(i) + "," + std::to_string(j) + ")");
}

}  // namespace patchproof
