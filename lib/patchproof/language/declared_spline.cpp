#include <patchproof/language/builtin_splines.hpp>

namespace patchproof {

namespace {

std::vector<Rational> clamped_uniform(int points, int degree, const Span& span) {
  if (points < degree + 1)
    throw Fault{span, "a spline of degree " + std::to_string(degree) + " needs at least " +
                          std::to_string(degree + 1) + " control points in each direction, not " +
                          std::to_string(points)};
  const int spans = points - degree;
  std::vector<Rational> knots(static_cast<std::size_t>(degree), 0);
  for (int k = 0; k <= spans; ++k) knots.push_back(k);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), Rational{spans});
  return knots;
}

std::vector<Rational> given_knots(const syntax::Expression& e, int points, int degree,
                                  const Scope& scope, Elaborator& elaborator) {
  const Term list = elaborator.expression(e, scope);
  const Type& type = list.type();
  if (list.operation() != Operation::matrix || !type.inner->is_scalar() ||
      (type.rows != 1 && type.columns != 1))
    throw Fault{e.span, "knots are a list of numbers", "as in: knots [0, 0, 0, 1, 1, 1]"};
  std::vector<Rational> knots;
  for (const Term& knot : list.children()) {
    if (!knot.is_number()) throw Fault{knot.span(), "a knot has to be a number"};
    knots.push_back(knot.number());
  }
  const auto expected = static_cast<std::size_t>(points + degree + 1);
  if (knots.size() != expected)
    throw Fault{e.span, std::to_string(points) + " control points of degree " +
                            std::to_string(degree) + " need " + std::to_string(expected) +
                            " knots, not " + std::to_string(knots.size())};
  int multiplicity = 1;
  for (std::size_t k = 1; k < knots.size(); ++k) {
    if (knots[k] < knots[k - 1])
      throw Fault{list.child(k).span(), "knots must not decrease"};
    multiplicity = knots[k] == knots[k - 1] ? multiplicity + 1 : 1;
    if (multiplicity > degree + 1)
      throw Fault{list.child(k).span(), "a knot occurs at most degree + 1 = " +
                                            std::to_string(degree + 1) + " times"};
  }
  const auto p = static_cast<std::size_t>(degree);
  if (knots[p] == knots[knots.size() - 1 - p])
    throw Fault{e.span, "these knots leave no interval for the spline to be defined on"};
  return knots;
}

}  // namespace

Spline declared_spline(const syntax::SplineData& data, const Scope& scope, Elaborator& elaborator) {
  constexpr int highest_degree = 40;
  const syntax::Expression& where = *data.control_points;
  Spline result;
  result.control_points = elaborator.expression(where, scope);
  const Type& type = result.control_points.type();
  if (!type.is_matrix())
    throw Fault{where.span, "the control points of a spline are a list or a net, not a " +
                                to_text(type)};
  if (!type.list && type.rows == 1) {
    std::vector<Term> points;
    for (int k = 0; k < type.columns; ++k)
      points.push_back(elaborator.construct().entry(result.control_points, {k}, where.span));
    result.control_points = elaborator.construct().list(std::move(points), where.span);
  }
  const Type shape = result.control_points.type();
  const bool curve = shape.list || shape.columns == 1;
  const std::size_t directions = curve ? 1 : 2;
  if (data.degrees.size() > directions)
    throw Fault{where.span, "a spline curve has one degree"};
  for (std::size_t k = 0; k < directions; ++k) {
    const int degree = data.degrees.at(data.degrees.size() == 1 ? 0 : k);
    const int points = k == 0 ? shape.rows : shape.columns;
    if (degree < 1 || degree > highest_degree)
      throw Fault{where.span, "the degree of a spline has to lie between 1 and " +
                                  std::to_string(highest_degree)};
    result.degrees.push_back(degree);
    if (data.knots.empty()) {
      result.knots.push_back(clamped_uniform(points, degree, where.span));
    } else {
      const auto& e = data.knots.at(data.knots.size() == 1 ? 0 : k);
      result.knots.push_back(given_knots(*e, points, degree, scope, elaborator));
    }
  }
  return result;
}

}  // namespace patchproof
