#pragma once

#include <vector>

#include <patchproof/net/segment_plan.hpp>
#include <patchproof/net/strip_number.hpp>

namespace patchproof {

/// A `DirectionPlan` in the numbers that are calculated with, span after span without gaps.
template <typename Number>
struct StripWeights {
  /// A control point as a combination of Bézier points of its span.
  struct Return {
    std::size_t control_point;
    std::vector<Number> weights;
    /// What the control point is multiplied by where the combination is not divided: the
    /// denominators of the span and of the weights.
    Number scale;
  };
  struct Seam {
    int order;
    int given_order;
    std::vector<Number> before;
    std::vector<Number> behind;
  };

  explicit StripWeights(const DirectionPlan& plan) : degree{static_cast<std::size_t>(plan.degree)} {
    for (const SpanPlan& span : plan.spans) {
      first.push_back(span.first);
      add(span.weights, weights);
      std::vector<Return>& returns = back.emplace_back();
      for (const ReturnPlan& one : span.back) {
        returns.push_back(
            {one.control_point, {}, strip_number<Number>(span.denominator * one.denominator)});
        add(one.weights, returns.back().weights);
      }
    }
    for (const SeamPlan& seam : plan.seams) {
      seams.push_back({seam.order, seam.given_order, {}, {}});
      add(seam.before, seams.back().before);
      add(seam.behind, seams.back().behind);
    }
  }

  std::size_t spans() const { return first.size(); }
  /// The (p+1) * (p+1) weights of a span.
  const Number* weights_of(std::size_t span) const {
    return weights.data() + span * (degree + 1) * (degree + 1);
  }

  std::size_t degree;
  /// Of each span the first control point.
  std::vector<std::size_t> first;
  std::vector<Number> weights;
  std::vector<std::vector<Return>> back;
  std::vector<Seam> seams;

 private:
  static void add(const std::vector<Rational>& from, std::vector<Number>& to) {
    for (const Rational& one : from) to.push_back(strip_number<Number>(one));
  }
};

}  // namespace patchproof
