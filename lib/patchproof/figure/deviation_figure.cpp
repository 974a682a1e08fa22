#include <patchproof/figure/kinds.hpp>
#include <patchproof/figure/surface_parts.hpp>

namespace patchproof {

bool is_deviation(const Studio& studio) { return studio.is_comparison(); }

Figure deviation_figure(Studio& studio, const FigureOptions& options) {
  const Subject& left = studio.subjects()[0];
  const Subject& right = studio.subjects()[1];
  Scene scene{left.is_plane ? Projection::flat() : Projection{options.view}};
  const auto count = static_cast<long>(options.cells);
  constexpr long arrows = 5;
  bool differs = false;
  const auto add_arrow = [&](const std::vector<Rational>& place) {
    const Point from = left.at(place);
    const Point to = right.at(place);
    if (from == to) return;
    differs = true;
    scene.add_arrow(from, to, Ink::deviation);
  };
  if (left.is_surface()) {
    const Grid first = grid_of(left, options.cells);
    const Grid second = grid_of(right, options.cells);
    add_facets(second, Ink::other, Ink::other, scene);
    add_isolines(second, 2 * options.cells_between_lines, scene);
    add_boundary(second, Ink::other_curve, scene);
    // The left one as wires, so that what lies under it can be seen.
    const std::size_t n = options.cells;
    for (std::size_t k = 0; k <= n; k += 2 * options.cells_between_lines) {
      const Ink ink = k == 0 || k == n ? Ink::boundary : Ink::wire;
      std::vector<Point> one_way;
      std::vector<Point> other_way;
      for (std::size_t j = 0; j <= n; ++j) {
        one_way.push_back(first.at(k, j));
        other_way.push_back(first.at(j, k));
      }
      scene.add_line(one_way, ink);
      scene.add_line(other_way, ink);
    }
    for (long i = 0; i <= arrows; ++i)
      for (long j = 0; j <= arrows; ++j) add_arrow({Rational{i, arrows}, Rational{j, arrows}});
  } else {
    std::vector<Point> first;
    std::vector<Point> second;
    for (long k = 0; k <= 8 * count; ++k) {
      first.push_back(left.at({Rational{k, 8 * count}}));
      second.push_back(right.at({Rational{k, 8 * count}}));
    }
    scene.add_line(first, Ink::boundary);
    scene.add_line(second, Ink::other_curve);
    for (long k = 0; k <= 2 * arrows; ++k) add_arrow({Rational{k, 2 * arrows}});
  }
  if (!differs)
    throw CannotDraw{"the two sides agree in the example that would be drawn",
                     "give the case numbers for which they differ"};
  return scene.figure(options.width, options.greatest_height);
}

}  // namespace patchproof
