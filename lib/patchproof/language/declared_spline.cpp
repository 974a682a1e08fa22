#include <patchproof/language/builtin_splines.hpp>

#include <algorithm>

namespace patchproof {

namespace {

Knots clamped_uniform(int points, int degree, const Span& span) {
  const int spans = points - degree;
  Knots knots(static_cast<std::size_t>(degree), number_term(0, span));
  for (int k = 0; k <= spans; ++k) knots.push_back(number_term(k, span));
  knots.insert(knots.end(), static_cast<std::size_t>(degree), number_term(spans, span));
  return knots;
}

// Different knots of which it can be told have to increase, and equal ones have to stand together.
void require_order(const Knots& knots, int degree) {
  Knots different;
  int multiplicity = 0;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const Term& knot = knots[k];
    const bool again = k > 0 && same_knot(knots[k - 1], knot);
    multiplicity = again ? multiplicity + 1 : 1;
    if (multiplicity > degree + 1)
      throw Fault{knot.span(),
                  "a knot occurs at most degree + 1 = " + std::to_string(degree + 1) + " times"};
    if (again) continue;
    // A number after a number is in order with all before; otherwise all count.
    const bool numbers = k > 0 && knot.is_number() && knots[k - 1].is_number();
    if (!numbers && std::any_of(different.begin(), different.end(),
                                [&](const Term& earlier) { return same_knot(earlier, knot); }))
      throw Fault{knot.span(), "equal knots stand together"};
    for (auto earlier = different.rbegin(); earlier != different.rend(); ++earlier) {
      const std::optional<int> order = order_of(*earlier, knot);
      if (order && *order < 0) throw Fault{knot.span(), "knots must not decrease"};
      if (order && *order == 0)
        throw Fault{knot.span(), "this knot is equal to one before it",
                    "equal knots are written alike"};
      if (numbers) break;
    }
    different.push_back(knot);
  }
}

Knots given_knots(const syntax::Expression& e, const Scope& scope, Elaborator& elaborator) {
  const Term list = elaborator.expression(e, scope);
  const Type& type = list.type();
  if (!type.is_matrix() || !type.inner->is_scalar() || (type.rows != 1 && type.columns != 1))
    throw Fault{e.span, "knots are a list of numbers", "as in: knots [0, 0, 0, 1, 1, 1]"};
  Knots knots;
  for (int k = 0; k < type.rows * type.columns; ++k) {
    const Term knot = elaborator.construct().entry(list, {k}, e.span);
    knots.push_back(elaborator.construct().scalar(scope, knot, "a knot"));
  }
  return knots;
}

std::string count_of(int n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

// The knots of one direction with `given` control points, or Bézier points when merged.
Knots knots_of(const syntax::SplineData& data, std::size_t direction, int given, int degree,
               const Scope& scope, Elaborator& elaborator) {
  const Span& where = data.control_points->span;
  const auto p = static_cast<std::size_t>(degree);
  if (data.merged && (given < degree + 1 || (given - 1) % degree != 0))
    throw Fault{where, "k pieces of degree " + std::to_string(degree) + " have " +
                           (degree == 1 ? "" : std::to_string(degree) + "*") +
                           "k + 1 Bézier points, not " + std::to_string(given)};
  if (!data.merged && given < degree + 1)
    throw Fault{where, "a spline of degree " + std::to_string(degree) + " needs at least " +
                           std::to_string(degree + 1) + " control points in each direction, not " +
                           std::to_string(given)};
  const int pieces = (given - 1) / degree;
  if (data.knots.empty())
    return clamped_uniform(data.merged ? pieces + degree : given, degree, where);
  const syntax::Expression& e = *data.knots.at(data.knots.size() == 1 ? 0 : direction);
  Knots knots = given_knots(e, scope, elaborator);
  const auto expected = static_cast<std::size_t>(given) + p + 1;
  if (!data.merged && knots.size() != expected)
    throw Fault{e.span, count_of(given, "control point") + " of degree " + std::to_string(degree) +
                            " need " + std::to_string(expected) + " knots, not " +
                            std::to_string(knots.size())};
  if (knots.size() < 2 * (p + 1))
    throw Fault{e.span, "a spline of degree " + std::to_string(degree) + " has at least " +
                            std::to_string(2 * (degree + 1)) + " knots, not " +
                            std::to_string(knots.size())};
  require_order(knots, degree);
  const auto intervals = static_cast<int>(spans_of(knots, degree).size());
  if (intervals == 0)
    throw Fault{e.span, "these knots leave no interval for the spline to be defined on"};
  if (data.merged && intervals != pieces)
    throw Fault{e.span, "these knots have " + count_of(intervals, "interval") +
                            ", and there are Bézier points of " + count_of(pieces, "piece")};
  return knots;
}

// A list or net; one row or column is a list.
Term points_of(const syntax::Expression& e, const std::string& what, const Scope& scope,
               Elaborator& elaborator) {
  const Term points = elaborator.expression(e, scope);
  const Type& type = points.type();
  if (!type.is_matrix())
    throw Fault{e.span, what + " of a spline are a list or a net, not a " + to_text(type)};
  if (type.list || (type.rows != 1 && type.columns != 1)) return points;
  std::vector<Term> entries;
  for (int k = 0; k < type.rows * type.columns; ++k)
    entries.push_back(elaborator.construct().entry(points, {k}, e.span));
  return elaborator.construct().list(std::move(entries), e.span);
}

}  // namespace

Spline declared_spline(const syntax::SplineData& data, const Scope& scope, Elaborator& elaborator) {
  const syntax::Expression& where = *data.control_points;
  Spline result;
  result.control_points =
      points_of(where, data.merged ? "the Bézier points" : "the control points", scope, elaborator);
  const Type shape = result.control_points.type();
  const bool curve = shape.list;
  const std::size_t directions = curve ? 1 : 2;
  if (data.degrees.size() > directions) throw Fault{where.span, "a spline curve has one degree"};
  if (data.knots.size() > directions)
    throw Fault{data.knots.back()->span, curve ? "a spline curve has one list of knots"
                                               : "a spline surface has two lists of knots"};
  if (data.weights) {
    result.weights = points_of(*data.weights, "the weights", scope, elaborator);
    const Type& type = result.weights.type();
    if (!type.inner->is_scalar())
      throw Fault{data.weights->span, "weights are numbers, this is a " + to_text(type)};
    const Term& weights = result.weights;
    if (weights.operation() == Operation::matrix &&
        std::all_of(weights.children().begin(), weights.children().end(), is_zero))
      throw Fault{data.weights->span, "all weights are 0: there is no curve or surface"};
    if (type.rows != shape.rows || type.columns != shape.columns)
      throw Fault{data.weights->span, "each point has one weight: a " + to_text(type) +
                                          " does not fit a " + to_text(shape)};
  }
  for (std::size_t k = 0; k < directions; ++k) {
    const int degree = data.degrees.at(data.degrees.size() == 1 ? 0 : k);
    if (degree < 1 || degree > highest_spline_degree)
      throw Fault{where.span, "the degree of a spline has to lie between 1 and " +
                                  std::to_string(highest_spline_degree)};
    result.degrees.push_back(degree);
    result.knots.push_back(
        knots_of(data, k, k == 0 ? shape.rows : shape.columns, degree, scope, elaborator));
  }
  if (!data.merged) return result;
  ControlNet net{result, elaborator, where.span};
  for (std::size_t k = 0; k < directions; ++k)
    net.combine(k, control_factors(result.knots[k], result.degrees[k], elaborator, where.span));
  result.control_points = net.points();
  result.weights = net.weights();
  return result;
}

}  // namespace patchproof
