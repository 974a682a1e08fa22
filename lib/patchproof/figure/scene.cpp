#include <patchproof/figure/scene.hpp>

#include <algorithm>
#include <numeric>
#include <optional>

namespace patchproof {

namespace {

enum Layer { hidden_if_behind, lines, arrows, dots, labels };

template <typename Visit>
void for_each_place(Shape& shape, const Visit& visit) {
  std::visit(
      [&](auto& p) {
        using Kind = std::decay_t<decltype(p)>;
        if constexpr (std::is_same_v<Kind, Polygon>) {
          for (Place& place : p.corners) visit(place);
        } else if constexpr (std::is_same_v<Kind, Polyline>) {
          for (Place& place : p.places) visit(place);
        } else if constexpr (std::is_same_v<Kind, Arrow>) {
          visit(p.from);
          visit(p.to);
        } else {
          visit(p.at);
        }
      },
      shape);
}

// Which of eight sides a direction points to: a side counts as straight when one part of the
// direction is less than 2/5 of the other.
Side side_of(const Rational& x, const Rational& y) {
  const Rational ax = abs(x);
  const Rational ay = abs(y);
  const bool sideways = 5 * ay < 2 * ax;
  const bool upright = 5 * ax < 2 * ay;
  if (sideways) return x < 0 ? Side::left : Side::right;
  if (upright) return y < 0 ? Side::below : Side::above;
  if (x == 0 && y == 0) return Side::above;
  if (y > 0) return x < 0 ? Side::above_left : Side::above_right;
  return x < 0 ? Side::below_left : Side::below_right;
}

struct Extent {
  Rational low;
  Rational high;
  bool empty = true;
  void include(const Rational& x) {
    low = empty ? x : std::min(low, x);
    high = empty ? x : std::max(high, x);
    empty = false;
  }
  Rational length() const { return high - low; }
};

}  // namespace

Place Scene::place(const Point& point) const {
  const Point seen = projection_(point);
  return {seen[0], seen[1]};
}

void Scene::add_facet(const std::vector<Point>& corners, Ink ink, int strength,
                      const Rational& lift) {
  Polygon polygon{{}, ink, strength};
  Rational depth = 0;
  for (const Point& corner : corners) {
    const Point seen = projection_(corner);
    polygon.corners.push_back({seen[0], seen[1]});
    depth += seen[2];
  }
  items_.push_back({hidden_if_behind, Rational{depth / static_cast<long>(corners.size()) + lift},
                    std::move(polygon)});
}

void Scene::add_segment(const Point& from, const Point& to, Ink ink, const Rational& lift) {
  const Rational depth = dot(projection_.towards_viewer(), from + to) / 2 + lift;
  items_.push_back({hidden_if_behind, depth, Polyline{{place(from), place(to)}, ink}});
}

void Scene::add_line(const std::vector<Point>& places, Ink ink) {
  Polyline line{{}, ink};
  for (const Point& point : places) line.places.push_back(place(point));
  items_.push_back({lines, 0, std::move(line)});
}

void Scene::add_arrow(const Point& from, const Point& to, Ink ink) {
  items_.push_back({arrows, 0, Arrow{place(from), place(to), ink}});
}

void Scene::add_dot(const Point& at, Ink ink) { items_.push_back({dots, 0, Dot{place(at), ink}}); }

void Scene::add_label(const Point& at, const Point& centre, const std::string& name) {
  const Point away = projection_(at - centre);
  items_.push_back({labels, 0, Label{place(at), side_of(away[0], away[1]), name}});
}

Figure Scene::figure(const Rational& width, const Rational& greatest_height) const {
  std::vector<std::size_t> order(items_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (items_[a].layer != items_[b].layer) return items_[a].layer < items_[b].layer;
    return items_[a].depth < items_[b].depth;
  });
  Figure result;
  for (const std::size_t k : order) result.shapes.push_back(items_[k].shape);
  Extent across;
  Extent upwards;
  for (Shape& shape : result.shapes)
    for_each_place(shape, [&](const Place& place) {
      across.include(place.x);
      upwards.include(place.y);
    });
  std::optional<Rational> scale;
  if (across.length() > 0) scale = width / across.length();
  if (upwards.length() > 0 && (!scale || *scale * upwards.length() > greatest_height))
    scale = greatest_height / upwards.length();
  const Rational factor = scale.value_or(Rational{1});
  for (Shape& shape : result.shapes)
    for_each_place(shape, [&](Place& place) {
      place = {Rational{(place.x - across.low) * factor},
               Rational{(place.y - upwards.low) * factor}};
    });
  result.width = across.length() * factor;
  result.height = upwards.length() * factor;
  return result;
}

}  // namespace patchproof
