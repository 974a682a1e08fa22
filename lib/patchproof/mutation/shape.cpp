#include <patchproof/mutation/shape.hpp>

#include <array>

namespace patchproof {

namespace {

using Point = std::vector<Rational>;

/// More than these are no exception.
constexpr std::size_t most_zeros = 3;

Point difference(const Point& a, const Point& b) {
  Point result;
  for (std::size_t k = 0; k < a.size(); ++k) result.push_back(a[k] - b[k]);
  return result;
}

bool is_zero(const Point& p) {
  for (const Rational& x : p)
    if (x != 0) return false;
  return true;
}

std::vector<Point> points_of(const NumericNet& net) {
  std::vector<Point> result;
  for (const auto& row : net) result.insert(result.end(), row.begin(), row.end());
  return result;
}

/// The dimension of the smallest flat space through all points: 0 a point, 1 a line, 2 a plane.
std::size_t rank(const std::vector<Point>& points) {
  std::vector<Point> rows;
  for (const Point& p : points) rows.push_back(difference(p, points.front()));
  std::size_t done = 0;
  for (std::size_t column = 0; column < points.front().size(); ++column) {
    std::size_t pivot = done;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[done], rows[pivot]);
    for (std::size_t r = done + 1; r < rows.size(); ++r) {
      const Rational factor = rows[r][column] / rows[done][column];
      for (std::size_t c = column; c < rows[r].size(); ++c) rows[r][c] -= factor * rows[done][c];
    }
    ++done;
  }
  return done;
}

bool is_symmetric(const NumericNet& net) {
  if (net.size() != net.front().size()) return false;
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (net[i][j] != net[j][i]) return false;
  return net.size() > 1;
}

// The same read backwards.
bool is_palindrome(const std::vector<Point>& list) {
  for (std::size_t k = 0; k < list.size(); ++k)
    if (list[k] != list[list.size() - 1 - k]) return false;
  return list.size() > 1;
}

bool is_without_twist(const NumericNet& net) {
  for (std::size_t i = 0; i + 1 < net.size(); ++i)
    for (std::size_t j = 0; j + 1 < net[i].size(); ++j)
      if (difference(net[i][j], net[i + 1][j]) != difference(net[i][j + 1], net[i + 1][j + 1]))
        return false;
  return true;
}

// "all z are 0": coordinates that are the same at all points.
std::string constant_coordinates(const std::vector<Point>& points) {
  constexpr std::array letters{"x", "y", "z"};
  std::string result;
  if (points.front().size() > letters.size() || points.front().size() < 2) return "";
  for (std::size_t c = 0; c < points.front().size(); ++c) {
    bool constant = true;
    for (const Point& p : points) constant = constant && p[c] == points.front()[c];
    if (constant)
      result += (result.empty() ? "" : ", ") + std::string{"all "} + letters[c] + " are " +
                to_text(points.front()[c]);
  }
  return result;
}

std::vector<std::string> zero_entries(const std::string& name, const NumericNet& net) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < net.size(); ++i)
    for (std::size_t j = 0; j < net[i].size(); ++j)
      if (is_zero(net[i][j]))
        result.push_back(name + "[" + (net.size() == 1 ? "" : std::to_string(i) + ",") +
                         std::to_string(j) + "]");
  return result;
}

}  // namespace

std::vector<std::string> shape_of(const std::string& name, const NumericNet& net) {
  std::vector<std::string> result;
  const std::vector<Point> points = points_of(net);
  if (points.size() < 2) return result;
  const std::size_t dimension = points.front().size();
  const std::size_t span = rank(points);
  if (span == 0)
    return {is_zero(points.front()) ? "all of " + name + " is zero"
                                    : "all entries of " + name + " are the same"};
  const std::string constant = constant_coordinates(points);
  const bool is_net = net.size() > 1 && net.front().size() > 1;
  if (span == 1 && dimension > 1) result.push_back("the points of " + name + " are on one line");
  if (span == 2 && dimension > 2)
    result.push_back("the points of " + name + " are in one plane" +
                     (constant.empty() ? "" : ": " + constant));
  if (is_symmetric(net))
    result.push_back(name + " is symmetric: " + name + "[i,j] = " + name + "[j,i]");
  if (is_net && is_without_twist(net))
    result.push_back(name + " has no twist: its cells are parallelograms");
  const std::vector<std::string> zeros = zero_entries(name, net);
  if (!zeros.empty() && zeros.size() <= most_zeros) {
    std::string list;
    for (const std::string& entry : zeros) list += (list.empty() ? "" : ", ") + entry;
    result.push_back(list + (zeros.size() == 1 ? " is zero" : " are zero"));
  }
  if (net.size() == 1 && is_palindrome(net.front()))
    result.push_back(name + " is the same read backwards");
  return result;
}

}  // namespace patchproof
