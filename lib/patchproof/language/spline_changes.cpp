#include <patchproof/language/spline_changes.hpp>

#include <algorithm>

#include <patchproof/language/builtin_splines.hpp>
#include <patchproof/language/builtins.hpp>
#include <patchproof/term/plain_text.hpp>

namespace patchproof {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Spline changed(const Spline& spline, std::size_t direction, int degree, Knots knots,
               const Factors& factors, Elaborator& elaborator, const Span& span) {
  ControlNet net{spline, elaborator, span};
  net.combine(direction, factors);
  Spline result = spline;
  result.control_points = net.points();
  result.weights = net.weights();
  result.degrees[direction] = degree;
  result.knots[direction] = std::move(knots);
  return result;
}

// The interval of the domain the knot lies in; of two that meet there, the second.
int interval_of(const Knots& knots, int degree, const Term& knot) {
  const std::vector<int> spans = spans_of(knots, degree);
  int result = -1;
  if (knot.is_number() && are_numbers(knots)) {
    const Rational& start = knots[at(degree)].number();
    const Rational& end = knots[knots.size() - 1 - at(degree)].number();
    if (knot.number() < start || knot.number() > end)
      throw Fault{knot.span(), "the knot " + to_text(knot.number()) + " lies outside the range [" +
                                   to_text(start) + ", " + to_text(end) + "] of this spline"};
    for (const int k : spans)
      if (knots[at(k)].number() <= knot.number()) result = k;
    return result;
  }
  for (const int k : spans)
    if (same_knot(knots[at(k)], knot)) result = k;
  if (result < 0 && same_knot(knots[at(spans.back()) + 1], knot)) result = spans.back();
  if (result < 0)
    throw Fault{knot.span(), "it is not known between which knots this knot lies",
                "inserted_points(d, degree, knots, k, t) takes the number k of the interval"};
  return result;
}

}  // namespace

bool changes_splines(const std::string& name) {
  return name == "insert_knot" || name == "elevate_degree";
}

Spline changed_spline(const std::string& name, const syntax::Expression& call, const Scope& scope,
                      Elaborator& elaborator) {
  require_arguments(name, call);
  const Spline spline = elaborator.spline(*call.arguments.front().value, scope);
  if (name == "elevate_degree")
    return with_higher_degree(spline, direction_of(spline, call, 0, "T", "T, u"), elaborator,
                              call.span);
  const std::size_t direction = direction_of(spline, call, 1, "T, t", "T, u, t");
  const syntax::ExpressionPointer& value = call.arguments.back().value;
  if (!value) throw Fault{call.span, "a knot cannot run"};
  const Term knot =
      elaborator.construct().scalar(scope, elaborator.expression(*value, scope), "a knot");
  return with_knot(spline, direction, knot, elaborator, call.span);
}

Spline with_knot(const Spline& spline, std::size_t direction, const Term& knot,
                 Elaborator& elaborator, const Span& span) {
  const Knots& knots = spline.knots[direction];
  const int degree = spline.degrees[direction];
  const int k = interval_of(knots, degree, knot);
  const auto there =
      std::count_if(knots.begin(), knots.end(), [&](const Term& t) { return same_knot(t, knot); });
  if (there >= degree)
    throw Fault{knot.span(), "this knot already has the multiplicity " + std::to_string(there) +
                                 ", and a knot is inserted up to the degree " +
                                 std::to_string(degree)};
  KnotArithmetic arithmetic{elaborator.construct(), span};
  const int points = spline.extent(direction);
  Factors factors;
  for (int i = 0; i <= points; ++i) {
    factors.emplace_back(at(points), number_term(0, span));
    std::vector<Term>& row = factors.back();
    if (i <= k - degree) {
      row[at(i)] = number_term(1, span);
    } else if (i > k) {
      row[at(i - 1)] = number_term(1, span);
    } else {
      const Term& low = knots[at(i)];
      const Term& high = knots[at(i + degree)];
      const Term length = arithmetic.difference(high, low);
      row[at(i - 1)] = arithmetic.ratio(arithmetic.difference(high, knot), length);
      row[at(i)] = arithmetic.ratio(arithmetic.difference(knot, low), length);
    }
  }
  Knots longer = knots;
  longer.insert(longer.begin() + k + 1, knot);
  return changed(spline, direction, degree, std::move(longer), factors, elaborator, span);
}

Spline with_higher_degree(const Spline& spline, std::size_t direction, Elaborator& elaborator,
                          const Span& span) {
  const Knots& knots = spline.knots[direction];
  const int degree = spline.degrees[direction];
  if (degree + 1 > highest_spline_degree)
    throw Fault{span, "the degree of a spline has to lie between 1 and " +
                          std::to_string(highest_spline_degree)};
  const std::vector<int> values = values_of(knots);
  const int start = values[at(degree)];
  const int end = values[values.size() - 1 - at(degree)];
  // Knots outside the domain that the new control points do not reach are left out.
  Knots raised;
  std::vector<int> raised_values;
  const auto add = [&](std::size_t k) {
    raised.push_back(knots[k]);
    raised_values.push_back(values[k]);
  };
  for (std::size_t k = 0; k < knots.size(); ++k) {
    add(k);
    if (k + 1 == knots.size() || values[k + 1] != values[k]) add(k);
  }
  const auto up_to_start = std::upper_bound(raised_values.begin(), raised_values.end(), start);
  const auto from_end = std::lower_bound(raised_values.begin(), raised_values.end(), end);
  const auto first = (up_to_start - raised_values.begin()) - (degree + 2);
  const auto last = (from_end - raised_values.begin()) + (degree + 2);
  raised = Knots(raised.begin() + first, raised.begin() + last);
  raised_values = std::vector<int>(raised_values.begin() + first, raised_values.begin() + last);

  const std::vector<int> spans = spans_of(knots, degree);
  std::vector<int> starts;
  for (const int k : spans) starts.push_back(values[at(k)]);
  KnotArithmetic arithmetic{elaborator.construct(), span};
  const Term share = number_term(Rational{1, degree + 1}, span);
  Factors factors;
  for (int i = 0; i + degree + 2 < static_cast<int>(raised.size()); ++i) {
    const int k = spans[piece_for_point(raised_values, starts, degree + 1, i)];
    factors.emplace_back(at(spline.extent(direction)), number_term(0, span));
    for (int left_out = 1; left_out <= degree + 1; ++left_out) {
      std::vector<Term> arguments;
      for (int j = 1; j <= degree + 1; ++j)
        if (j != left_out) arguments.push_back(raised[at(i + j)]);
      const std::vector<Term> part =
          blossom(knots, degree, k, arguments, elaborator.workshop(), elaborator.construct(), span);
      for (int j = 0; j <= degree; ++j) {
        Term& factor = factors.back()[at(k - degree + j)];
        factor = arithmetic.sum(factor, arithmetic.product(share, part[at(j)]));
      }
    }
  }
  return changed(spline, direction, degree + 1, std::move(raised), factors, elaborator, span);
}

ControlNet bezier_form(const Spline& spline, Elaborator& elaborator, const Span& span) {
  ControlNet net{spline, elaborator, span};
  for (std::size_t k = 0; k < spline.directions(); ++k)
    net.combine(k, bezier_factors(spline.knots[k], spline.degrees[k], elaborator, span));
  return net;
}

}  // namespace patchproof
