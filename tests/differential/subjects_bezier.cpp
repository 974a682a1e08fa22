#include "subjects.hpp"

namespace patchproof::differential {
namespace {

Node between(const Node& a, const Node& b, const Node& t) {
  return sum({product({difference(number(1), t), a}), product({t, b})});
}

Node de_casteljau(std::vector<Node> points, const Node& t) {
  while (points.size() > 1) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      points[i] = between(points[i], points[i + 1], t);
    points.pop_back();
  }
  return points.front();
}

long binomial(long n, long k) {
  long result = 1;
  for (long i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
  return result;
}

/// A Bernstein polynomial as a product of powers.
Node bernstein(long n, long i, const Node& t) {
  std::vector<Node> factors{number(binomial(n, i))};
  if (i > 0) factors.push_back(power(t, static_cast<unsigned>(i)));
  if (i < n) factors.push_back(power(difference(number(1), t), static_cast<unsigned>(n - i)));
  return product(factors);
}

Node bernstein_call(const Node& n, const Node& i, const Node& t) {
  return call("bernstein", {n, i, t}, Type::scalar);
}

/// The coefficients of t^0, t^1, …: differences of the points.
std::vector<Node> powers_of(const std::vector<Node>& points) {
  const long n = static_cast<long>(points.size()) - 1;
  std::vector<Node> result;
  for (long k = 0; k <= n; ++k) {
    std::vector<Node> terms;
    for (long i = 0; i <= k; ++i) {
      const long sign = (k - i) % 2 == 0 ? 1 : -1;
      terms.push_back(product(
          {number(sign * binomial(n, k) * binomial(k, i)), points[static_cast<std::size_t>(i)]}));
    }
    result.push_back(sum(terms));
  }
  return result;
}

Node in_bernstein(const std::vector<Node>& points, const Node& t) {
  std::vector<Node> terms;
  const long n = static_cast<long>(points.size()) - 1;
  for (long i = 0; i <= n; ++i)
    terms.push_back(product({bernstein(n, i, t), points[static_cast<std::size_t>(i)]}));
  return sum(terms);
}

Node in_powers(const std::vector<Node>& points, const Node& t) {
  const std::vector<Node> coefficients = powers_of(points);
  std::vector<Node> terms{coefficients[0]};
  for (std::size_t k = 1; k < coefficients.size(); ++k)
    terms.push_back(product({power(t, static_cast<unsigned>(k)), coefficients[k]}));
  return sum(terms);
}

}  // namespace

Example bezier_curve_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"t"});
  declare_scalars(draft, {"a", "c"});
  const std::size_t n = 1 + choices.below(4);
  declare_array(draft, "b", n + 1, 0, Type::point);
  const Node t = scalar_name("t");
  const Node degree = number(static_cast<long>(n));
  const Node i = scalar_name("i");
  const std::vector<Node> points = draft.points;
  const Node list = matrix_name("b");
  const auto bezier = [](const Node& of) { return call("bezier", {of}, Type::function); };

  std::vector<Node> steps;
  for (std::size_t k = 0; k < n; ++k) steps.push_back(difference(points[k + 1], points[k]));
  std::vector<Node> reversed(points.rbegin(), points.rend());
  const Node elevated =
      call("elevated", {list, number(1 + static_cast<long>(choices.below(2)))}, Type::matrix);
  // The curve over [x, y] at (t - x)/(y - x); the lengths are powers of 2.
  const Node part = call("restricted_points", {list, number("1/2"), number("3/2")}, Type::matrix);
  const Node in_part = difference(t, number("1/2"));
  DeclaredFunction curve{"C", {"t"}, Type::point, 2, {}};
  curve.alternatives = {
      {"", running_sum(product({bernstein_call(degree, i, t), element("b", {i}, Type::point)}), "i",
                       number(0), degree)},
      {"", in_bernstein(points, t)},
      {"", in_powers(points, t)},
      {"", de_casteljau(points, t)},
      {"", apply(bezier(elevated), {t}, Type::point)},
      {"", apply(bezier(part), {in_part}, Type::point)},
      {"", in_bernstein(reversed, difference(number(1), t))},
      {"t", product({degree, de_casteljau(steps, t)})},
      {"t", product({degree, in_bernstein(steps, t)})},
  };
  declare_defined(draft, curve, bezier(list));
  const Node node =
      choices.once_in(2) ? random_point(choices, draft, 1) : random_application(choices, draft);
  return example_of(choices, name, draft, {node, node}, holds);
}

Example bezier_patch_example(Choices& choices, const std::string& name, bool holds) {
  Draft draft;
  declare_parameters(draft, {"u", "v"});
  const std::size_t m = 1 + choices.below(3), n = 1 + choices.below(3);
  declare_array(draft, "b", m + 1, n + 1, Type::point);
  const Node u = scalar_name("u"), v = scalar_name("v");
  const Node i = scalar_name("i"), j = scalar_name("j");
  const Node net = matrix_name("b");
  const Node in_u = number(static_cast<long>(m)), in_v = number(static_cast<long>(n));
  const auto bezier = [](const Node& of) { return call("bezier", {of}, Type::function); };

  std::vector<Node> rows, rows_in_powers, steps_in_u, row_steps;
  for (std::size_t k = 0; k <= m; ++k) {
    std::vector<Node> row, steps;
    for (std::size_t l = 0; l <= n; ++l) row.push_back(element_of(draft, "b", k, l));
    for (std::size_t l = 0; l < n; ++l) steps.push_back(difference(row[l + 1], row[l]));
    rows.push_back(de_casteljau(row, v));
    rows_in_powers.push_back(in_powers(row, v));
    row_steps.push_back(de_casteljau(steps, v));
  }
  for (std::size_t k = 0; k < m; ++k) steps_in_u.push_back(difference(rows[k + 1], rows[k]));
  const Node elevated = call(
      "elevated_net", {net, number(1), number(static_cast<long>(choices.below(2)))}, Type::matrix);
  const Node part =
      call("restricted_net", {net, number(0), number(2), number(1), number(0)}, Type::matrix);
  const Node term = product(
      {bernstein_call(in_u, i, u), bernstein_call(in_v, j, v), element("b", {i, j}, Type::point)});
  DeclaredFunction patch{"r", {"u", "v"}, Type::point, 2, {}};
  patch.alternatives = {
      {"", running_sum(running_sum(term, "i", number(0), in_u), "j", number(0), in_v)},
      {"", in_bernstein(rows, u)},
      {"", in_bernstein(rows_in_powers, u)},
      {"", de_casteljau(rows, u)},
      {"", apply(bezier(elevated), {u, v}, Type::point)},
      {"",
       apply(bezier(part), {product({number("1/2"), u}), difference(number(1), v)}, Type::point)},
      {"u", product({in_u, de_casteljau(steps_in_u, u)})},
      {"v", product({in_v, in_bernstein(row_steps, u)})},
  };
  declare_defined(draft, patch, bezier(net));
  const Node node =
      choices.once_in(3) ? random_point(choices, draft, 1) : random_application(choices, draft);
  return example_of(choices, name, draft, {node, node}, holds);
}

}  // namespace patchproof::differential
