#include "constructions.hpp"

#include <stdexcept>

namespace patchproof::differential {
namespace {

const Value first_parameter = value_of_variable("$1");
const Value second_parameter = value_of_variable("$2");
const Value one = value_of_number(1);

Value entry(const Value& of, std::size_t i, std::size_t j = 0) { return {1, 1, {of.at(i, j)}}; }
std::size_t size_from(const Value& value) {
  return static_cast<std::size_t>(numerator(plain_value(value.entries.at(0).above)));
}

/// (1-t)*a + t*b.
Value between(const Value& a, const Value& b, const Value& t) {
  return plus(times(plus(one, minus(t)), a), times(t, b));
}

/// The blossom of a Bézier curve: de Casteljau with another parameter in each step.
Value blossom(std::vector<Value> points, const std::vector<Value>& parameters) {
  for (const Value& t : parameters) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      points[i] = between(points[i], points[i + 1], t);
    points.pop_back();
  }
  return points.at(0);
}

std::vector<Value> row(const Value& net, std::size_t i) {
  std::vector<Value> points;
  for (std::size_t j = 0; j < net.columns; ++j) points.push_back(entry(net, i, j));
  return points;
}

std::vector<Value> column(const Value& net, std::size_t j) {
  std::vector<Value> points;
  for (std::size_t i = 0; i < net.rows; ++i) points.push_back(entry(net, i, j));
  return points;
}

Value row_matrix(const std::vector<Value>& points) {
  Value result{1, points.size(), {}};
  for (const Value& point : points) result.entries.push_back(point.entries.at(0));
  return result;
}

Value transposed(const Value& a) {
  Value result{a.columns, a.rows, {}};
  for (std::size_t j = 0; j < a.columns; ++j)
    for (std::size_t i = 0; i < a.rows; ++i) result.entries.push_back(a.at(i, j));
  return result;
}

Value bezier_at(const std::vector<Value>& points, const Value& t) {
  return blossom(points, std::vector<Value>(points.size() - 1, t));
}

/// Applies something that takes lists of points to each column.
template <typename Change>
Value by_columns(const Value& net, const Change& change) {
  Value rows{0, 0, {}};
  for (std::size_t j = 0; j < net.columns; ++j) {
    const Value changed = row_matrix(change(column(net, j)));
    rows.columns = changed.columns;
    ++rows.rows;
    rows.entries.insert(rows.entries.end(), changed.entries.begin(), changed.entries.end());
  }
  return transposed(rows);
}

std::vector<Value> elevated_once(const std::vector<Value>& points) {
  const std::size_t n = points.size();
  std::vector<Value> result{points.front()};
  for (std::size_t i = 1; i < n; ++i)
    result.push_back(between(points[i], points[i - 1], value_of_number(Rational(i, n))));
  result.push_back(points.back());
  return result;
}

std::vector<Value> elevated(std::vector<Value> points, std::size_t times_more) {
  for (std::size_t k = 0; k < times_more; ++k) points = elevated_once(points);
  return points;
}

std::vector<Value> restricted(const std::vector<Value>& points, const Value& a, const Value& c) {
  const std::size_t n = points.size() - 1;
  std::vector<Value> result;
  for (std::size_t i = 0; i <= n; ++i) {
    std::vector<Value> parameters(n - i, a);
    parameters.insert(parameters.end(), i, c);
    result.push_back(blossom(points, parameters));
  }
  return result;
}

/// The cubic with values p, q and slopes m, n at 0 and 1, as Bézier points.
std::vector<Value> hermite_points(const Value& p, const Value& q, const Value& m, const Value& n) {
  const Value third = value_of_number(Rational(1, 3));
  return {p, plus(p, times(third, m)), plus(q, minus(times(third, n))), q};
}

/// The same in each column of (value 0, value 1, slope 0, slope 1).
std::vector<Value> hermite_column(const std::vector<Value>& of) {
  return hermite_points(of.at(0), of.at(1), of.at(2), of.at(3));
}

Function patch_of_net(const Value& net) {
  const Value points = by_columns(
      net, [](const auto& of) { return std::vector<Value>{bezier_at(of, first_parameter)}; });
  return {2, bezier_at(row(points, 0), second_parameter)};
}

/// Any three blocks of a bicubic patch over the corners, and no twists.
Value hermite_matrix(const Value& p, const Value& pu, const Value& pv) {
  Value g{4, 4, std::vector<PlainFraction>(16)};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      g.entries[4 * i + j] = p.at(i, j);
      g.entries[4 * (i + 2) + j] = pu.at(i, j);
      g.entries[4 * i + j + 2] = pv.at(i, j);
    }
  return g;
}

/// The net of the boundary points of b: sums of the two linear interpolations, less that of
/// corners.
Value discrete_coons(const Value& b) {
  Value result{b.rows, b.columns, {}};
  const std::size_t m = b.rows - 1, n = b.columns - 1;
  for (std::size_t i = 0; i <= m; ++i)
    for (std::size_t j = 0; j <= n; ++j) {
      const Value s = value_of_number(Rational(i, m)), t = value_of_number(Rational(j, n));
      const Value lofted = plus(between(entry(b, 0, j), entry(b, m, j), s),
                                between(entry(b, i, 0), entry(b, i, n), t));
      const Value corners = between(between(entry(b, 0, 0), entry(b, m, 0), s),
                                    between(entry(b, 0, n), entry(b, m, n), s), t);
      result.entries.push_back(plus(lofted, minus(corners)).entries[0]);
    }
  return result;
}

Value at(const Function& function, const Value& parameter) {
  return applied(function, {parameter});
}

/// The Coons patch blended with 1 - f, f in u and 1 - g, g in v.
Value coons_value(const std::vector<Given>& given, const Value& f, const Value& g) {
  const Function& south = given.at(0).function;
  const Function& north = given.at(1).function;
  const Function& west = given.at(2).function;
  const Function& east = given.at(3).function;
  const Value& u = first_parameter;
  const Value& v = second_parameter;
  const Value zero = value_of_number(0);
  const Value lofted =
      plus(between(at(south, u), at(north, u), g), between(at(west, v), at(east, v), f));
  const Value corners = between(between(at(south, zero), at(south, one), f),
                                between(at(north, zero), at(north, one), f), g);
  return plus(lofted, minus(corners));
}

}  // namespace

Function construction(const std::string& name, const std::vector<Given>& given) {
  const Value& u = first_parameter;
  const Value& v = second_parameter;
  const Value& first = given.at(0).value;
  if (name == "bezier" || name == "bezier_curve" || name == "bezier_patch") {
    if (first.columns == 1) return {1, bezier_at(column(first, 0), u)};
    return patch_of_net(first);
  }
  if (name == "hermite_curve")
    return {
        1, bezier_at(hermite_points(first, given.at(1).value, given.at(2).value, given.at(3).value),
                     u)};
  if (name == "bilinear")
    return {2, between(between(first, given.at(1).value, u),
                       between(given.at(2).value, given.at(3).value, u), v)};
  if (name == "ruled")
    return {2, between(at(given.at(0).function, u), at(given.at(1).function, u), v)};
  if (name == "ruled_in_u")
    return {2, between(at(given.at(0).function, v), at(given.at(1).function, v), u)};
  if (name == "ruled_over") {
    const Value& a = given.at(2).value;
    const Value length = plus(given.at(3).value, minus(a));
    return {2, between(at(given.at(0).function, u), at(given.at(1).function, u),
                       divided(plus(v, minus(a)), length))};
  }
  if (name == "coons") return {2, coons_value(given, u, v)};
  if (name == "partially_bicubic_coons")
    return {2, coons_value(given, built_in("smooth_step", {u}), built_in("smooth_step", {v}))};
  if (name == "translation_surface")
    return {2, plus(at(given.at(0).function, u), at(given.at(1).function, v))};
  if (name == "hermite_loft")
    return {2, bezier_at(hermite_points(at(given.at(0).function, u), at(given.at(1).function, u),
                                        at(given.at(2).function, u), at(given.at(3).function, u)),
                         v)};
  const bool ferguson = name == "ferguson";
  if (ferguson || name == "bicubic_hermite") {
    const Value g = ferguson ? hermite_matrix(first, given.at(1).value, given.at(2).value) : first;
    return patch_of_net(
        transposed(by_columns(transposed(by_columns(g, hermite_column)), hermite_column)));
  }
  throw std::logic_error{"no construction " + name};
}

Value built_in(const std::string& name, const std::vector<Value>& given) {
  const Value& first = given.at(0);
  if (name == "transpose") return transposed(first);
  if (name == "binomial" || name == "bernstein") {
    const std::size_t n = size_from(first);
    const std::size_t i = size_from(given.at(1));
    std::vector<Value> points(n + 1, value_of_number(0));
    points.at(i) = one;
    if (name == "bernstein") return bezier_at(points, given.at(2));
    Integer count = 1;
    for (std::size_t k = 0; k < i; ++k) count = count * (n - k) / (k + 1);
    return value_of_number(Rational{count});
  }
  if (name == "smooth_step")
    return bezier_at({value_of_number(0), value_of_number(0), one, one}, first);
  if (name == "discrete_coons") return discrete_coons(first);
  if (name == "dot") return times(transposed(first), given.at(1));
  if (name == "cross") {
    const Value& b = given.at(1);
    Value result{3, 1, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const Value part =
          plus(times(entry(first, i), entry(b, j)), minus(times(entry(first, j), entry(b, i))));
      result.entries.push_back(part.entries[0]);
    }
    return result;
  }
  if (name == "det") {
    if (given.size() == 3)
      return built_in("dot", {first, built_in("cross", {given.at(1), given.at(2)})});
    if (first.rows == 1) return first;
    Value result = value_of_number(0);
    for (std::size_t k = 0; k < first.rows; ++k) {
      Value minor{first.rows - 1, first.rows - 1, {}};
      for (std::size_t i = 1; i < first.rows; ++i)
        for (std::size_t j = 0; j < first.columns; ++j)
          if (j != k) minor.entries.push_back(first.at(i, j));
      const Value part = times(entry(first, 0, k), built_in("det", {minor}));
      result = plus(result, k % 2 == 0 ? part : minus(part));
    }
    return result;
  }
  if (name == "elevated")
    return by_columns(first, [&](const auto& of) { return elevated(of, size_from(given.at(1))); });
  if (name == "elevated_net") {
    const Value in_u =
        by_columns(first, [&](const auto& of) { return elevated(of, size_from(given.at(1))); });
    return transposed(by_columns(
        transposed(in_u), [&](const auto& of) { return elevated(of, size_from(given.at(2))); }));
  }
  if (name == "restricted_points")
    return by_columns(first,
                      [&](const auto& of) { return restricted(of, given.at(1), given.at(2)); });
  if (name == "restricted_net") {
    const Value in_u =
        by_columns(first, [&](const auto& of) { return restricted(of, given.at(1), given.at(2)); });
    return transposed(by_columns(transposed(in_u), [&](const auto& of) {
      return restricted(of, given.at(3), given.at(4));
    }));
  }
  throw std::logic_error{"no function " + name};
}

}  // namespace patchproof::differential
