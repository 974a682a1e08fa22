#include <patchproof/figure/surface_parts.hpp>

#include <algorithm>

namespace patchproof {

namespace {

// Percent of ink for a facet: less where it faces the light. cos^2 of the angle needs no root.
int strength_of(const Point& normal, const Point& light) {
  const Rational square = dot(normal, normal) * dot(light, light);
  if (square == 0) return 60;
  const Rational cosine = dot(normal, light);
  const Rational percent = 84 - 58 * cosine * cosine / square;
  return static_cast<int>(numerator(percent) / denominator(percent));
}

std::vector<Point> quad(const Grid& grid, std::size_t i, std::size_t j) {
  return {grid.at(i, j), grid.at(i + 1, j), grid.at(i + 1, j + 1), grid.at(i, j + 1)};
}

}  // namespace

Grid grid_of(const Subject& patch, std::size_t cells) {
  Grid grid{cells, {}};
  const auto count = static_cast<long>(cells);
  for (long i = 0; i <= count; ++i)
    for (long j = 0; j <= count; ++j)
      grid.points.push_back(patch.at({Rational{i, count}, Rational{j, count}}));
  return grid;
}

Point centre_of(const Grid& grid) {
  const std::size_t n = grid.cells;
  return Rational{1, 4} * (grid.at(0, 0) + grid.at(n, 0) + grid.at(0, n) + grid.at(n, n));
}

Rational lift_over(const Grid& grid, const Projection& projection) {
  Rational largest = 0;
  for (std::size_t i = 0; i < grid.cells; ++i)
    for (std::size_t j = 0; j < grid.cells; ++j) {
      std::vector<Rational> depths;
      for (const Point& corner : quad(grid, i, j))
        depths.push_back(dot(projection.towards_viewer(), corner));
      const auto [low, high] = std::minmax_element(depths.begin(), depths.end());
      largest = std::max(largest, Rational{*high - *low});
    }
  return largest * Rational{5, 8};
}

void add_facets(const Grid& grid, Ink front, Ink back, Scene& scene) {
  const Point light = scene.projection().direction({-2, 5}, {3, 5}, {3, 4});
  for (std::size_t i = 0; i < grid.cells; ++i)
    for (std::size_t j = 0; j < grid.cells; ++j) {
      const std::vector<Point> corners = quad(grid, i, j);
      const Point normal = cross(corners[2] - corners[0], corners[3] - corners[1]);
      const bool is_front = dot(normal, scene.projection().towards_viewer()) >= 0;
      scene.add_facet(corners, is_front ? front : back, strength_of(normal, light));
    }
}

void add_isolines(const Grid& grid, std::size_t step, Scene& scene) {
  const Rational lift = lift_over(grid, scene.projection());
  for (std::size_t k = step; k < grid.cells; k += step)
    for (std::size_t j = 0; j < grid.cells; ++j) {
      scene.add_segment(grid.at(k, j), grid.at(k, j + 1), Ink::isoline, lift);
      scene.add_segment(grid.at(j, k), grid.at(j + 1, k), Ink::isoline, lift);
    }
}

void add_boundary(const Grid& grid, Ink ink, Scene& scene) {
  const Rational lift = 2 * lift_over(grid, scene.projection());
  const std::size_t n = grid.cells;
  const auto add = [&](const Point& from, const Point& to) {
    if (from != to) scene.add_segment(from, to, ink, lift);
  };
  for (std::size_t j = 0; j < n; ++j) {
    add(grid.at(0, j), grid.at(0, j + 1));
    add(grid.at(n, j), grid.at(n, j + 1));
    add(grid.at(j, 0), grid.at(j + 1, 0));
    add(grid.at(j, n), grid.at(j + 1, n));
  }
}

void add_net(const DrawnNet& net, const Rational& lift, Scene& scene) {
  // Short pieces, so that each is hidden or not by itself.
  constexpr long pieces = 12;
  const auto add_leg = [&](const Point& from, const Point& to) {
    for (long k = 0; k < pieces; ++k)
      scene.add_segment(from + Rational{k, pieces} * (to - from),
                        from + Rational{k + 1, pieces} * (to - from), Ink::net, lift);
  };
  for (std::size_t i = 0; i < net.rows; ++i)
    for (std::size_t j = 0; j < net.columns; ++j) {
      if (i + 1 < net.rows) add_leg(net.at(i, j), net.at(i + 1, j));
      if (j + 1 < net.columns) add_leg(net.at(i, j), net.at(i, j + 1));
      scene.add_dot(net.at(i, j), Ink::net_point);
    }
}

std::optional<DrawnNet> bezier_net_of(const Subject& subject) {
  constexpr unsigned greatest_degree = 9;
  const std::vector<Variable>& variables = subject.function.variables();
  std::array<unsigned, 2> degrees{0, 0};
  for (const Fraction& coordinate : subject.function.coordinates()) {
    if (!coordinate.is_polynomial()) return std::nullopt;
    for (const Variable v : coordinate.numerator().variables())
      if (std::find(variables.begin(), variables.end(), v) == variables.end()) return std::nullopt;
    for (std::size_t k = 0; k < variables.size(); ++k)
      degrees[k] = std::max(degrees[k], coordinate.numerator().degree(variables[k]));
  }
  if (subject.is_graph || std::max(degrees[0], degrees[1]) > greatest_degree) return std::nullopt;
  for (const Rational& end : {Rational{0}, Rational{1}}) {
    const std::vector<Rational> ends(variables.size(), end);
    if (subject.function.parameters(ends) != ends) return std::nullopt;
  }
  const auto binomial = [](unsigned n, unsigned k) {
    Rational result = 1;
    for (unsigned i = 0; i < k; ++i) result *= Rational{n - i, i + 1};
    return result;
  };
  DrawnNet net{degrees[0] + 1, degrees[1] + 1, {}};
  net.points.assign(net.rows * net.columns, Point{});
  for (std::size_t c = 0; c < subject.function.coordinates().size(); ++c)
    for (const auto& term : subject.function.coordinates()[c].numerator().terms()) {
      const unsigned k = term.monomial.exponent(variables[0]);
      const unsigned l = variables.size() > 1 ? term.monomial.exponent(variables[1]) : 0;
      for (unsigned i = k; i <= degrees[0]; ++i)
        for (unsigned j = l; j <= degrees[1]; ++j)
          net.points[i * net.columns + j][c] += term.coefficient * binomial(i, k) * binomial(j, l) /
                                                binomial(degrees[0], k) / binomial(degrees[1], l);
    }
  return net;
}

void add_twists(const Subject& patch, const Grid& grid, Scene& scene) {
  const SampledFunction mixed = patch.function.derivative({1, 1});
  const std::size_t n = grid.cells;
  Rational longest = 0;
  std::vector<std::pair<Point, Point>> arrows;
  std::vector<std::string> names;
  for (const int i : {0, 1})
    for (const int j : {0, 1}) {
      const Point value = mixed.value({Rational{i}, Rational{j}});
      const Point twist = patch.is_graph ? Point{0, 0, value[0]} : value;
      for (const Rational& coordinate : twist)
        longest = std::max(longest, Rational{abs(coordinate)});
      arrows.emplace_back(grid.at(i == 0 ? 0 : n, j == 0 ? 0 : n), twist);
      names.push_back(patch.name + "_" + patch.parameters[0] + patch.parameters[1] + "(" +
                      std::to_string(i) + "," + std::to_string(j) + ")");
    }
  if (longest == 0) return;
  Rational size = 0;
  for (const Rational& coordinate : grid.at(n, n) - grid.at(0, 0))
    size = std::max(size, Rational{abs(coordinate)});
  const Rational factor = size / (3 * longest);
  for (std::size_t k = 0; k < arrows.size(); ++k) {
    const auto& [from, twist] = arrows[k];
    if (twist == Point{}) continue;
    const Point to = from + factor * twist;
    scene.add_arrow(from, to, Ink::twist);
    scene.add_label(to, from, names[k]);
  }
}

}  // namespace patchproof
