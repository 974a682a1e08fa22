#include <algorithm>

#include <patchproof/figure/kinds.hpp>
#include <patchproof/figure/surface_parts.hpp>

namespace patchproof {

namespace {

using Line = std::vector<Point>;

// The four boundary curves as lines of grid points.
std::vector<Line> edges_of(const Grid& grid) {
  std::vector<Line> result(4);
  for (std::size_t k = 0; k <= grid.cells; ++k) {
    result[0].push_back(grid.at(k, 0));
    result[1].push_back(grid.at(k, grid.cells));
    result[2].push_back(grid.at(0, k));
    result[3].push_back(grid.at(grid.cells, k));
  }
  return result;
}

// An edge that both have, in whichever direction; one that is a point is none.
std::vector<Line> common_edges(const Grid& a, const Grid& b) {
  std::vector<Line> result;
  for (const Line& first : edges_of(a))
    for (Line second : edges_of(b)) {
      if (first.front() == first[first.size() / 2]) continue;
      const bool same = first == second;
      std::reverse(second.begin(), second.end());
      if (same || first == second) result.push_back(first);
    }
  return result;
}

Point mean(const std::vector<Point>& points) {
  Point total{};
  for (const Point& point : points) total = total + point;
  return Rational{1, static_cast<long>(points.size())} * total;
}

}  // namespace

bool are_surfaces(const Studio& studio) {
  return std::any_of(studio.subjects().begin(), studio.subjects().end(),
                     [](const Subject& s) { return s.is_surface(); });
}

Figure surface_figure(Studio& studio, const FigureOptions& options) {
  const std::vector<Subject>& subjects = studio.subjects();
  const bool flat =
      std::all_of(subjects.begin(), subjects.end(), [](const Subject& s) { return s.is_plane; });
  Scene scene{flat ? Projection::flat() : Projection{options.view}};
  std::vector<Grid> grids;
  std::vector<Point> centres;
  for (const Subject& subject : subjects) {
    if (!subject.is_surface()) {
      Line line;
      const auto count = static_cast<long>(options.cells) * 8;
      for (long k = 0; k <= count; ++k) line.push_back(subject.at({Rational{k, count}}));
      scene.add_line(line, Ink::other_curve);
      continue;
    }
    grids.push_back(grid_of(subject, options.cells));
    centres.push_back(centre_of(grids.back()));
  }
  Rational lift = 0;
  for (const Grid& grid : grids) lift = std::max(lift, lift_over(grid, scene.projection()));
  std::size_t next = 0;
  for (const Subject& subject : subjects) {
    if (!subject.is_surface()) continue;
    const Grid& grid = grids[next++];
    if (options.zebra && !flat) {
      add_zebra(subject, grid, scene);
    } else {
      add_facets(grid, Ink::surface, flat ? Ink::surface : Ink::back, scene);
      add_isolines(grid, options.cells_between_lines, scene);
    }
    add_boundary(grid, Ink::boundary, scene);
    // Several nets at once are a tangle, and have to be asked for.
    std::optional<DrawnNet> net = grids.size() == 1 || options.net ? subject.net : std::nullopt;
    if (!net && options.net) net = bezier_net_of(subject);
    if (net && !options.zebra) add_net(*net, 3 * lift, scene);
    if (options.twists) add_twists(subject, grid, scene);
    if (grids.size() == 1 && !options.twists) add_names(subject, grid, studio, scene);
  }
  for (std::size_t a = 0; a < grids.size(); ++a)
    for (std::size_t b = a + 1; b < grids.size(); ++b)
      for (const Line& edge : common_edges(grids[a], grids[b]))
        for (std::size_t k = 0; k + 1 < edge.size(); ++k)
          scene.add_segment(edge[k], edge[k + 1], Ink::common, 3 * lift);
  if (grids.size() > 1) {
    const Point middle = mean(centres);
    next = 0;
    std::vector<Point> taken;
    for (const Subject& subject : subjects) {
      if (!subject.is_surface()) continue;
      // On the edge that is farthest from the others.
      const std::vector<Line> edges = edges_of(grids[next++]);
      std::optional<Point> best;
      const auto apart = [&](const Point& p) { return Rational{dot(p - middle, p - middle)}; };
      for (const Line& edge : edges) {
        const Point& place = edge[options.cells / 2];
        if (std::find(taken.begin(), taken.end(), place) != taken.end()) continue;
        if (!best || apart(place) > apart(*best)) best = place;
      }
      if (!best) continue;
      taken.push_back(*best);
      scene.add_label(*best, middle, subject.name);
    }
  }
  return scene.figure(options.width, options.greatest_height);
}

}  // namespace patchproof
