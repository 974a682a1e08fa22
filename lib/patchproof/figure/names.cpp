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
  try {
    for (int k = 0; k <= 4; ++k) {
      const Rational t{k, 4};
      if (curve.at({t}) != patch.at(place_on(edge, t))) return false;
    }
    return true;
  } catch (const OutsideTheory&) {
    return false;  // some other curve of the case, which is not to be drawn
  }
}

// Whether a facet lies before the point, by more than the lift.
bool is_hidden(const Point& point, const Grid& grid, const Projection& projection) {
  const Point seen = projection(point);
  const Rational lift = lift_over(grid, projection);
  const auto side = [&](const Point& a, const Point& b) {
    return Rational{(b[0] - a[0]) * (seen[1] - a[1]) - (b[1] - a[1]) * (seen[0] - a[0])};
  };
  for (std::size_t i = 0; i < grid.cells; ++i)
    for (std::size_t j = 0; j < grid.cells; ++j) {
      const Point a = projection(grid.at(i, j));
      const Point b = projection(grid.at(i + 1, j));
      const Point c = projection(grid.at(i + 1, j + 1));
      const Point d = projection(grid.at(i, j + 1));
      if (a[2] + b[2] + c[2] + d[2] <= 4 * (seen[2] + lift)) continue;
      const std::array<Rational, 4> sides{side(a, b), side(b, c), side(c, d), side(d, a)};
      const auto positive = [](const Rational& x) { return x > 0; };
      const auto negative = [](const Rational& x) { return x < 0; };
      if (std::all_of(sides.begin(), sides.end(), positive) ||
          std::all_of(sides.begin(), sides.end(), negative))
        return true;
    }
  return false;
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
  const auto add = [&](const Point& at, const std::vector<Rational>& place,
                       const std::string& name) {
    if (!is_hidden(at, grid, scene.projection())) scene.add_label(at, inside(place), name);
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
      add(corner, {Rational{i}, Rational{j}}, named->name);
      any = true;
    }
  const std::vector<Subject> curves = studio.named_curves();
  for (const Edge& edge : edges()) {
    const auto named = std::find_if(curves.begin(), curves.end(), [&](const Subject& curve) {
      return runs_along(curve, patch, edge);
    });
    if (named == curves.end()) continue;
    const std::vector<Rational> middle = place_on(edge, {1, 2});
    add(patch.at(middle), middle, named->name);
    any = true;
  }
  if (any) return;
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      add(grid.at(i == 0 ? 0 : grid.cells, j == 0 ? 0 : grid.cells), {Rational{i}, Rational{j}},
          patch.name + "(" + std::to_string(i) + "," + std::to_string(j) + ")");
}

}  // namespace patchproof
