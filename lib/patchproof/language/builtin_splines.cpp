#include <patchproof/language/builtin_splines.hpp>

#include <algorithm>

#include <patchproof/term/plain_text.hpp>

namespace patchproof {

namespace {

// The numbers k of the spans [knots[k], knots[k+1]] that are not empty, inside the domain.
std::vector<int> spans_of(const std::vector<Rational>& knots, int degree) {
  std::vector<int> result;
  const auto last = static_cast<int>(knots.size()) - degree - 1;
  for (int k = degree; k < last; ++k)
    if (knots[static_cast<std::size_t>(k)] < knots[static_cast<std::size_t>(k) + 1])
      result.push_back(k);
  return result;
}

int span_number(const Spline& spline, std::size_t direction, long wanted, const Span& span) {
  const std::vector<int> spans = spans_of(spline.knots[direction], spline.degrees[direction]);
  if (wanted < 0 || wanted >= static_cast<long>(spans.size()))
    throw Fault{span, "this spline has the segments 0.." + std::to_string(spans.size() - 1) +
                          " in this direction, not " + std::to_string(wanted)};
  return spans[static_cast<std::size_t>(wanted)];
}

// Factors of the control points in the blossom value f(arguments) on one span: de Boor's algorithm
// with a different parameter at each level.
std::vector<Rational> blossom(const std::vector<Rational>& knots, int degree, int span,
                              const std::vector<Rational>& arguments, std::size_t points) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<std::vector<Rational>> d(at(degree) + 1, std::vector<Rational>(points, 0));
  for (int i = 0; i <= degree; ++i) d[at(i)][at(span - degree + i)] = 1;
  for (int level = 1; level <= degree; ++level) {
    for (int i = degree; i >= level; --i) {
      const Rational& low = knots[at(span - degree + i)];
      const Rational& high = knots[at(span + 1 + i - level)];
      const Rational ratio = (arguments[at(level - 1)] - low) / (high - low);
      for (std::size_t p = 0; p < points; ++p)
        d[at(i)][p] = (1 - ratio) * d[at(i) - 1][p] + ratio * d[at(i)][p];
    }
  }
  return d[at(degree)];
}

// One row of factors for each Bézier point of all pieces.
std::vector<std::vector<Rational>> conversion(const std::vector<Rational>& knots, int degree,
                                              std::size_t points, const Span& where) {
  std::vector<std::vector<Rational>> rows;
  for (const int span : spans_of(knots, degree)) {
    const Rational& a = knots[static_cast<std::size_t>(span)];
    const Rational& b = knots[static_cast<std::size_t>(span) + 1];
    for (int i = 0; i <= degree; ++i) {
      std::vector<Rational> arguments(static_cast<std::size_t>(degree - i), a);
      arguments.insert(arguments.end(), static_cast<std::size_t>(i), b);
      const std::vector<Rational> row = blossom(knots, degree, span, arguments, points);
      if (i == 0 && !rows.empty()) {
        if (rows.back() != row)
          throw Fault{where, "this spline is not continuous: an inner knot has a multiplicity above "
                             "the degree"};
        continue;
      }
      rows.push_back(row);
    }
  }
  return rows;
}

Term combination(const std::vector<Rational>& factors, const std::vector<Term>& points,
                 const Span& span, Elaborator& elaborator) {
  std::vector<Term> parts;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (factors[k] == 0) continue;
    parts.push_back(elaborator.construct().product(Scope{}, {number_term(factors[k], span), points[k]},
                                                   "**", span));
  }
  const std::string signs(parts.size(), '+');
  return elaborator.construct().sum(Scope{}, std::move(parts), signs, span);
}

}  // namespace

Term net_of(const syntax::Expression& value, const std::vector<syntax::Binder>& binders,
            const Span& span, const Scope& scope, Elaborator& elaborator) {
  if (binders.empty() || binders.size() > 2)
    throw Fault{span, "a net needs one or two running indices"};
  std::vector<int> extents;
  for (const syntax::Binder& binder : binders) {
    const auto [first, last] = elaborator.interval(binder.interval, scope);
    if (first != 0)
      throw Fault{binder.name.span, "the indices of a net start at 0, not at " +
                                        std::to_string(first)};
    extents.push_back(last + 1);
  }
  std::vector<Term> entries;
  for (const std::vector<int>& values : elaborator.combinations(binders, scope)) {
    elaborator.workshop().count_term(span);
    const Scope inner = Elaborator::bound(scope, binders, values);
    entries.push_back(
        decayed(elaborator.construct().value(inner, elaborator.expression(value, inner))));
  }
  if (binders.size() == 1) return elaborator.construct().list(std::move(entries), span);
  std::vector<std::vector<Term>> rows(static_cast<std::size_t>(extents[0]));
  for (std::size_t k = 0; k < entries.size(); ++k)
    rows[k / static_cast<std::size_t>(extents[1])].push_back(entries[k]);
  return elaborator.construct().matrix(scope, std::move(rows), span);
}

Term segment(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  Construction& construct = elaborator.construct();
  const Spline& spline = elaborator.spline(*call.arguments[0].value, scope);
  const std::size_t directions = spline.degrees.size();
  if (call.arguments.size() != directions + 1)
    throw Fault{call.span, directions == 1 ? "a spline curve has one segment number"
                                           : "a spline surface has two segment numbers",
                directions == 1 ? "segment(T, i)" : "segment(T, i, j)"};
  std::vector<int> spans;
  for (std::size_t k = 0; k < directions; ++k) {
    if (!call.arguments[k + 1].value) throw Fault{call.span, "a segment number cannot run"};
    const Term number = elaborator.expression(*call.arguments[k + 1].value, scope);
    spans.push_back(span_number(spline, k, construct.whole_number(number, "a segment number"),
                                call.span));
  }
  const std::vector<std::string> names =
      directions == 1 ? std::vector<std::string>{"t"} : std::vector<std::string>{"u", "v"};
  const Term function = construct.function(names, call.span, [&](const std::vector<Term>& t) {
    const auto basis = [&](std::size_t k, int i) {
      return construct.make(Operation::bspline_basis, Type::scalar(), {t[k]},
                            BasisFunction{spline.degrees[k], i, spans[k], spline.knots[k]}, call.span);
    };
    std::vector<Term> parts;
    for (int i = spans[0] - spline.degrees[0]; i <= spans[0]; ++i) {
      if (directions == 1) {
        const Term point = construct.entry(spline.control_points, {i}, call.span);
        parts.push_back(construct.product(scope, {basis(0, i), point}, "**", call.span));
        continue;
      }
      for (int j = spans[1] - spline.degrees[1]; j <= spans[1]; ++j) {
        const Term point = construct.entry(spline.control_points, {i, j}, call.span);
        parts.push_back(construct.product(scope, {basis(0, i), basis(1, j), point}, "***", call.span));
      }
    }
    const std::string signs(parts.size(), '+');
    return construct.sum(scope, std::move(parts), signs, call.span);
  });
  return construct.definition("segment", function, {}, call.span);
}

Term bezier_net(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  Construction& construct = elaborator.construct();
  const Spline& spline = elaborator.spline(*call.arguments[0].value, scope);
  const Type& type = spline.control_points.type();
  const auto first = conversion(spline.knots[0], spline.degrees[0],
                                static_cast<std::size_t>(type.rows), call.span);
  const auto columns = static_cast<std::size_t>(type.list ? 1 : type.columns);
  // Down the columns first, then along the rows.
  std::vector<std::vector<Term>> half;
  for (const std::vector<Rational>& factors : first) {
    half.emplace_back();
    for (std::size_t j = 0; j < columns; ++j) {
      std::vector<Term> column;
      for (int i = 0; i < type.rows; ++i)
        column.push_back(construct.entry(
            spline.control_points,
            type.list ? std::vector<int>{i} : std::vector<int>{i, static_cast<int>(j)}, call.span));
      half.back().push_back(combination(factors, column, call.span, elaborator));
    }
  }
  if (type.list) {
    std::vector<Term> points;
    for (const auto& row : half) points.push_back(row.front());
    return construct.definition("bezier_net", construct.list(std::move(points), call.span), {},
                                call.span);
  }
  const auto second = conversion(spline.knots[1], spline.degrees[1], columns, call.span);
  std::vector<std::vector<Term>> rows;
  for (const auto& row : half) {
    rows.emplace_back();
    for (const std::vector<Rational>& factors : second)
      rows.back().push_back(combination(factors, row, call.span, elaborator));
  }
  return construct.definition("bezier_net", construct.matrix(scope, std::move(rows), call.span), {},
                              call.span);
}

Term control_points(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator) {
  return elaborator.spline(*call.arguments[0].value, scope).control_points;
}

}  // namespace patchproof
