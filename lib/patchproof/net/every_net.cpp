#include <algorithm>

#include <patchproof/net/every_net.hpp>

namespace patchproof {

namespace {

/// Weights of control points, from the first one of a span or of two neighbours on.
using Weights = std::vector<Rational>;

/// The r-th difference of the Bézier points from `point` on, in steps of `step`, as weights of
/// control points; these begin with number `first`, and there are `size` of them.
Weights difference(const SpanPlan& span, std::size_t degree, std::size_t point, int step, int r,
                   std::size_t first, std::size_t size) {
  Weights sum(size);
  Rational factor{1};
  for (int i = 0; i <= r; ++i) {
    const std::size_t row = static_cast<std::size_t>(static_cast<int>(point) + step * i);
    for (std::size_t a = 0; a <= degree; ++a)
      sum[span.first - first + a] += factor * span.weights[row * (degree + 1) + a];
    factor *= Rational{i - r, i + 1};
  }
  return sum;
}

bool joins(const SpanPlan& before, const SpanPlan& behind, const SeamPlan& seam,
           std::size_t degree) {
  const std::size_t size = behind.first - before.first + degree + 1;
  for (int r = 0; r <= std::min(seam.order, seam.given_order); ++r) {
    const auto k = static_cast<std::size_t>(r);
    const Weights left = difference(before, degree, degree, -1, r, before.first, size);
    const Weights right = difference(behind, degree, k, -1, r, before.first, size);
    for (std::size_t a = 0; a < size; ++a)
      if (left[a] * seam.before[k] != right[a] * seam.behind[k]) return false;
  }
  return true;
}

bool leads_back(const SpanPlan& span, const ReturnPlan& back, std::size_t degree) {
  for (std::size_t a = 0; a <= degree; ++a) {
    Rational sum;
    for (std::size_t r = 0; r <= degree; ++r)
      sum += back.weights[r] * span.weights[r * (degree + 1) + a];
    const bool own = span.first + a == back.control_point;
    if (sum != (own ? span.denominator * back.denominator : Rational{})) return false;
  }
  return true;
}

}  // namespace

bool holds_for_every_net(const DirectionPlan& plan) {
  const auto degree = static_cast<std::size_t>(plan.degree);
  for (std::size_t s = 0; s < plan.spans.size(); ++s) {
    const SpanPlan& span = plan.spans[s];
    if (s > 0 && !joins(plan.spans[s - 1], span, plan.seams[s - 1], degree)) return false;
    for (const ReturnPlan& back : span.back)
      if (!leads_back(span, back, degree)) return false;
  }
  return true;
}

}  // namespace patchproof
