#include <algorithm>

#include <patchproof/figure/kinds.hpp>
#include <patchproof/figure/surface_parts.hpp>

namespace patchproof {

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
  const auto count = static_cast<long>(options.cells) * 3;
  for (const Subject& subject : subjects) {
    std::vector<Point> line;
    for (long k = 0; k <= count; ++k) line.push_back(subject.at({Rational{k, count}}));
    const Point centre = Rational{1, 2} * (line.front() + line.back());
    std::optional<ControlNet> net = subject.net;
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
    const Point& middle = line[line.size() / 2];
    scene.add_label(middle, net ? middle + (middle - centre) : centre, subject.name);
  }
  return scene.figure(options.width, options.greatest_height);
}

}  // namespace patchproof
