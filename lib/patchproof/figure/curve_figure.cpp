#include <algorithm>

#include <patchproof/figure/kinds.hpp>
#include <patchproof/figure/surface_parts.hpp>

namespace patchproof {

namespace {

// Arrows through zero, a little longer than what they measure.
void add_axes(const std::vector<std::vector<Point>>& graphs, Scene& scene) {
  Point low = graphs.front().front();
  Point high = low;
  for (const std::vector<Point>& graph : graphs)
    for (const Point& point : graph)
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], point[k]);
        high[k] = std::max(high[k], point[k]);
      }
  low[1] = std::min(low[1], Rational{0});
  high[1] = std::max(high[1], Rational{0});
  const Rational right = high[0] + (high[0] - low[0]) / 12;
  const Rational top = high[1] + (high[1] - low[1]) / 12;
  scene.add_arrow({low[0], 0, 0}, {right, 0, 0}, Ink::axis);
  scene.add_arrow({low[0], low[1], 0}, {low[0], top, 0}, Ink::axis);
}

// A point beside an inner point of a line, square to it and lower in the figure.
Point beneath(const std::vector<Point>& line, std::size_t index, const Projection& projection) {
  const Point along = projection(line[index + 1] - line[index - 1]);
  const int sign = along[0] < 0 ? -1 : 1;
  return line[index] -
         projection.direction(Rational{-sign * along[1]}, Rational{sign * along[0]}, 0);
}

}  // namespace

bool are_curves(const Studio& studio) {
  return !studio.subjects().empty() &&
         std::none_of(studio.subjects().begin(), studio.subjects().end(),
                      [](const Subject& s) { return s.is_surface(); });
}

Figure curve_figure(Studio& studio, const FigureOptions& options) {
  const std::vector<Subject>& subjects = studio.subjects();
  const bool flat =
      std::all_of(subjects.begin(), subjects.end(), [](const Subject& s) { return s.is_plane; });
  Scene scene{flat ? Projection::flat() : Projection{options.view}};
  const auto count = static_cast<long>(options.cells) * 8;
  std::vector<std::vector<Point>> graphs;
  for (std::size_t number = 0; number < subjects.size(); ++number) {
    const Subject& subject = subjects[number];
    std::vector<Point> line;
    for (long k = 0; k <= count; ++k) line.push_back(subject.at({Rational{k, count}}));
    const Point centre = Rational{1, 2} * (line.front() + line.back());
    std::optional<DrawnNet> net = subject.net;
    if (!net && options.net) net = bezier_net_of(subject);
    if (net) {
      scene.add_line(net->points, Ink::net);
      for (const Point& point : net->points) scene.add_dot(point, Ink::net_point);
      const std::vector<NamedPoint> points = studio.named_points();
      for (const Point& point : net->points)
        for (const NamedPoint& named : points)
          if (named.point == point) {
            scene.add_label(point, centre, named.name);
            break;
          }
    }
    scene.add_line(line, Ink::boundary);
    if (subject.is_graph) graphs.push_back(line);
    // Each at a place of its own: curves may cross in the middle.
    const std::size_t place_index = line.size() * (2 * number + 1) / (2 * subjects.size());
    const Point& place = line[place_index];
    scene.add_label(place,
                    net ? place + (place - centre) : beneath(line, place_index, scene.projection()),
                    subject.name);
  }
  if (!graphs.empty()) add_axes(graphs, scene);
  return scene.figure(options.width, options.greatest_height);
}

}  // namespace patchproof
