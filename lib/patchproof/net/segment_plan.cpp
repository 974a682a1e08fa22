#include <algorithm>

#include <patchproof/algebra/number.hpp>
#include <patchproof/net/bezier_weights.hpp>
#include <patchproof/net/common_denominator.hpp>
#include <patchproof/net/segment_plan.hpp>

namespace patchproof {

namespace {

/// No such denominator leads to numbers of a machine word.
constexpr std::size_t most_bits_of_denominator = 4096;

/// Makes the weights whole numbers; false when what they are over is too large.
bool make_whole(std::vector<Rational>& weights, Rational& denominator) {
  const std::optional<Integer> over = common_denominator(weights, most_bits_of_denominator);
  if (!over) return false;
  denominator = Rational{*over};
  for (Rational& weight : weights) weight *= denominator;
  return true;
}

/// before : behind as whole numbers without a common divisor.
void set_ratio(const Rational& before, const Rational& behind, SeamPlan& seam) {
  const Rational ratio = before / behind;
  seam.before.emplace_back(numerator(ratio));
  seam.behind.emplace_back(denominator(ratio));
}

Rational sum_of_absolutes(const std::vector<Rational>& weights, std::size_t from,
                          std::size_t count) {
  Rational sum;
  for (std::size_t k = from; k < from + count; ++k) sum += abs(weights[k]);
  return sum;
}

SeamPlan seam_plan(const KnotVector& knots, std::size_t span, int continuity, const SpanPlan& left,
                   const SpanPlan& right) {
  SeamPlan seam;
  const int p = knots.degree();
  seam.given_order = p - knots.multiplicity_behind(span);
  seam.order = std::min(p, std::max(continuity, seam.given_order));
  // A derivative of order r is p!/(p-r)! times the r-th difference over length^r and denominator.
  const Rational before = knots.length_of(span);
  const Rational behind = knots.length_of(span + 1);
  for (int r = 0; r <= seam.order; ++r)
    set_ratio(power(behind, r) * right.denominator, power(before, r) * left.denominator, seam);
  return seam;
}

SpanPlan span_plan(const KnotVector& knots, std::size_t s, std::size_t first_new) {
  const auto p = static_cast<std::size_t>(knots.degree());
  SpanPlan span;
  span.first = knots.knot_of_span(s) - p;
  span.weights = bezier_weights(knots, s);
  for (std::size_t i = std::max(span.first, first_new); i <= span.first + p; ++i)
    span.back.push_back({i, control_weights(knots, s, i), Rational{1}});
  return span;
}

bool make_whole(SpanPlan& span) {
  return make_whole(span.weights, span.denominator) &&
         std::all_of(span.back.begin(), span.back.end(),
                     [](ReturnPlan& back) { return make_whole(back.weights, back.denominator); });
}

std::optional<DirectionPlan> planned(const KnotVector& knots, int continuity, bool whole) {
  DirectionPlan plan;
  plan.degree = knots.degree();
  std::size_t first_new = 0;
  for (std::size_t s = 0; s < knots.spans(); ++s) {
    SpanPlan& span = plan.spans.emplace_back(span_plan(knots, s, first_new));
    if (whole && !make_whole(span)) return std::nullopt;
    first_new = knots.knot_of_span(s) + 1;
    if (s > 0) plan.seams.push_back(seam_plan(knots, s - 1, continuity, plan.spans[s - 1], span));
  }
  return plan;
}

}  // namespace

DirectionPlan direction_plan(const KnotVector& knots, int continuity) {
  return *planned(knots, continuity, false);
}

std::optional<DirectionPlan> whole_direction_plan(const KnotVector& knots, int continuity) {
  return planned(knots, continuity, true);
}

Rational DirectionPlan::largest_weights() const {
  Rational largest;
  const auto size = static_cast<std::size_t>(degree) + 1;
  for (const SpanPlan& span : spans)
    for (std::size_t r = 0; r < size; ++r)
      largest = std::max(largest, sum_of_absolutes(span.weights, r * size, size));
  return largest;
}

Rational DirectionPlan::largest_back_weights() const {
  Rational largest;
  for (const SpanPlan& span : spans)
    for (const ReturnPlan& back : span.back)
      largest = std::max(largest, sum_of_absolutes(back.weights, 0, back.weights.size()));
  return largest;
}

Rational DirectionPlan::largest_denominator() const {
  Rational largest{1};
  for (const SpanPlan& span : spans) largest = std::max(largest, span.denominator);
  return largest;
}

Rational DirectionPlan::largest_back_denominator() const {
  Rational largest{1};
  for (const SpanPlan& span : spans)
    for (const ReturnPlan& back : span.back) largest = std::max(largest, back.denominator);
  return largest;
}

Rational DirectionPlan::largest_comparison() const {
  Rational largest{1};
  for (const SeamPlan& seam : seams)
    for (std::size_t r = 0; r < seam.before.size(); ++r)
      largest = std::max(largest, power(Rational{2}, static_cast<long>(r)) *
                                      std::max(seam.before[r], seam.behind[r]));
  return largest;
}

}  // namespace patchproof
