#include <algorithm>
#include <set>
#include <stdexcept>

#include <patchproof/algebra/number.hpp>
#include <patchproof/net/common_denominator.hpp>
#include <patchproof/net/every_net.hpp>
#include <patchproof/net/net_builder.hpp>
#include <patchproof/net/segments.hpp>
#include <patchproof/net/strip_conversion.hpp>

namespace patchproof {

namespace {

/// A denominator beyond this leaves no room in any word.
constexpr std::size_t most_denominator_bits = 128;

/// A net and what is done with it.
struct Task {
  const PointNet& net;
  const KnotVector& u;
  const KnotVector& v;
  int continuity;
  const StripSink& sink;
};

/// Both plans over common denominators, that of the net, and the bits all numbers fit.
struct WholePlan {
  DirectionPlan u;
  DirectionPlan v;
  Rational denominator{1};
  std::size_t bits = 0;
};

/// A bound of every number on the way: the sum of the absolute summands of each combination, from
/// the largest numerator of the net on. A comparison is the last step, and the way back as well.
std::size_t bits_for(const PointNet& net, const WholePlan& plan) {
  Rational height{1};
  for (const Rational& value : net.coordinates)
    if (value > height || -value > height) height = abs(value);
  height *= plan.denominator;
  const Rational segment = height * plan.u.largest_weights() * plan.v.largest_weights();
  const Rational compared =
      segment * std::max(plan.u.largest_comparison(), plan.v.largest_comparison());
  const Rational returned = segment * plan.u.largest_back_weights() * plan.v.largest_back_weights();
  const Rational expected = height * plan.u.largest_denominator() *
                            plan.u.largest_back_denominator() * plan.v.largest_denominator() *
                            plan.v.largest_back_denominator();
  return bit_length(Rational{floor(std::max({compared, returned, expected}))}) + 1;
}

std::optional<WholePlan> whole_plan(const Task& task) {
  const std::optional<Integer> over =
      common_denominator(task.net.coordinates, most_denominator_bits);
  if (!over) return std::nullopt;
  std::optional<DirectionPlan> u = whole_direction_plan(task.u, task.continuity);
  std::optional<DirectionPlan> v = whole_direction_plan(task.v, task.continuity);
  if (!u || !v) return std::nullopt;
  WholePlan plan{std::move(*u), std::move(*v), Rational{*over}, 0};
  plan.bits = bits_for(task.net, plan);
  return plan;
}

template <typename Number>
class Strip : public SegmentStrip {
 public:
  Strip(const StripConversion<Number>& strips, std::size_t s, const DirectionPlan& u,
        const DirectionPlan& v, const Rational& denominator)
      : strips_{strips}, s_{s}, v_{v}, denominator_{denominator * u.spans[s].denominator} {}

  Rational coordinate(std::size_t t, std::size_t k, std::size_t l, std::size_t c) const override {
    return to_rational(strips_.at(t, k, l, c)) / (denominator_ * v_.spans[t].denominator);
  }
  std::size_t number() const override { return s_; }

 private:
  const StripConversion<Number>& strips_;
  std::size_t s_;
  const DirectionPlan& v_;
  Rational denominator_;
};

/// Collects what differs across the seams in one direction.
template <typename Number>
class SeamRecord {
 public:
  SeamRecord(const KnotVector& knots, const DirectionPlan& plan, std::size_t spans_along,
             int continuity, SeamFindings& findings)
      : knots_{knots}, plan_{plan}, findings_{findings} {
    findings_.seams = plan.seams.size();
    findings_.edges = plan.seams.size() * spans_along;
    findings_.order = continuity;
    findings_.given_order = plan.degree;
    for (const SeamPlan& seam : plan.seams)
      findings_.given_order = std::min(findings_.given_order, seam.given_order);
  }

  /// `along`: the span of the difference in this direction. False when splines have no difference
  /// there.
  bool add(const Difference<Number>& found, std::size_t along, const Rational& denominator) {
    if (found.order <= findings_.order) {
      if (!findings_.first_break) findings_.first_break = described(found, along, denominator);
      // Spans in u come in their order: what is behind is only counted.
      if (found.u_span != u_span_) {
        counted_ += broken_.size();
        broken_.clear();
        u_span_ = found.u_span;
      }
      broken_.insert(found.v_span);
      findings_.broken_edges = counted_ + broken_.size();
    }
    return found.order > plan_.seams[along].given_order;
  }

 private:
  SeamBreak described(const Difference<Number>& found, std::size_t along,
                      const Rational& denominator) const {
    Rational factor{1};
    for (int k = 0; k < found.order; ++k) factor *= plan_.degree - k;
    const auto derivative = [&](const Number& difference, std::size_t span) {
      return factor * to_rational(difference) /
             (power(knots_.length_of(span), found.order) * plan_.spans[span].denominator *
              denominator);
    };
    return {found.u_span,
            found.v_span,
            found.order,
            found.coefficient,
            found.coordinate,
            derivative(found.before, along),
            derivative(found.behind, along + 1)};
  }

  const KnotVector& knots_;
  const DirectionPlan& plan_;
  SeamFindings& findings_;
  /// Spans in v of the broken edges of one span in u; how many there were in the spans before.
  std::set<std::size_t> broken_;
  std::size_t u_span_ = 0;
  std::size_t counted_ = 0;
};

/// Whether splines over these knots have the continuity at every seam, for any points.
bool given_by_knots(const DirectionPlan& plan, int continuity) {
  return std::all_of(plan.seams.begin(), plan.seams.end(), [&](const SeamPlan& seam) {
    return seam.given_order >= std::min(continuity, plan.degree);
  });
}

template <typename Number>
void convert(const Task& task, const WholePlan& plan, const Number* points,
             SegmentFindings& findings) {
  const StripWeights<Number> u{plan.u};
  const StripWeights<Number> v{plan.v};
  StripConversion<Number> strips{points, task.net.columns, task.net.dimension, u, v};
  SeamRecord<Number> u_record{task.u, plan.u, v.spans(), task.continuity, findings.u};
  SeamRecord<Number> v_record{task.v, plan.v, u.spans(), task.continuity, findings.v};
  bool right = findings.for_every_net;
  const bool compare_u = findings.from_numbers || !given_by_knots(plan.u, task.continuity);
  const bool compare_v = findings.from_numbers || !given_by_knots(plan.v, task.continuity);
  findings.are_the_surface = right;
  if (!compare_u && !compare_v && !task.sink) return;
  for (std::size_t s = 0; s < u.spans(); ++s) {
    strips.convert(s);
    if (s > 0 && compare_u)
      strips.compare_with_last(s, [&](const Difference<Number>& found) {
        const Rational over = plan.denominator * plan.v.spans[found.v_span].denominator;
        right = u_record.add(found, found.u_span, over) && right;
      });
    if (compare_v)
      strips.compare_inside(s, [&](const Difference<Number>& found) {
        const Rational over = plan.denominator * plan.u.spans[found.u_span].denominator;
        right = v_record.add(found, found.v_span, over) && right;
      });
    if (findings.from_numbers) right = strips.leads_back(s) && right;
    if (task.sink) task.sink(Strip<Number>{strips, s, plan.u, plan.v, plan.denominator});
  }
  findings.are_the_surface = right;
}

template <typename Number>
std::vector<Number> numerators(const PointNet& net, const Rational& denominator) {
  std::vector<Number> result;
  result.reserve(net.coordinates.size());
  const bool is_word = denominator.is_small();
  const std::int64_t over = is_word ? denominator.words().numerator : 0;
  for (const Rational& value : net.coordinates) {
    // The product is a numerator that is known to fit.
    if (is_word && value.is_small())
      result.push_back(Number{value.words().numerator} * (over / value.words().denominator));
    else
      result.push_back(strip_number<Number>(value * denominator));
  }
  return result;
}

std::size_t unused(const DirectionPlan& plan, const KnotVector& knots) {
  std::size_t used = 0;
  for (const SpanPlan& span : plan.spans) used += span.back.size();
  return knots.points() - used;
}

Arithmetic fastest(std::size_t bits) {
  if (bits == 0 || bits > 128) return Arithmetic::fractions;
  return bits <= 64 ? Arithmetic::words : Arithmetic::double_words;
}

void require_fit(const KnotVector& knots, std::size_t points, const std::string& direction) {
  if (knots.points() != points)
    throw std::invalid_argument{"the knots in " + direction + " are for " +
                                counted(knots.points(), "point") + ", not " +
                                std::to_string(points)};
}

}  // namespace

std::string to_text(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::words:
      return "words of 64 bits";
    case Arithmetic::double_words:
      return "words of 128 bits";
    default:
      return "fractions of any size";
  }
}

SegmentFindings segments_of(const PointNet& net, const KnotVector& u, const KnotVector& v,
                            int continuity, const StripSink& sink,
                            std::optional<Arithmetic> arithmetic) {
  require_fit(u, net.rows, "u");
  require_fit(v, net.columns, "v");
  const Task task{net, u, v, continuity, sink};
  SegmentFindings findings;
  findings.u_spans = u.spans();
  findings.v_spans = v.spans();
  std::optional<WholePlan> plan = whole_plan(task);
  findings.bits = plan ? plan->bits : 0;
  const Arithmetic enough = fastest(findings.bits);
  findings.arithmetic = arithmetic.value_or(enough);
  if (findings.arithmetic < enough)
    throw std::overflow_error{to_text(findings.arithmetic) + " are not shown to be enough"};
  if (plan) findings.for_every_net = holds_for_every_net(plan->u) && holds_for_every_net(plan->v);
  if (findings.arithmetic == Arithmetic::fractions) {
    plan = WholePlan{direction_plan(u, continuity), direction_plan(v, continuity), Rational{1}, 0};
    findings.for_every_net = holds_for_every_net(plan->u) && holds_for_every_net(plan->v);
    findings.from_numbers = net.rows * net.columns <= most_points_of_fractions;
    convert<Rational>(task, *plan, net.coordinates.data(), findings);
  } else if (findings.arithmetic == Arithmetic::words) {
    convert<std::int64_t>(task, *plan, numerators<std::int64_t>(net, plan->denominator).data(),
                          findings);
  } else {
    convert<DoubleWord>(task, *plan, numerators<DoubleWord>(net, plan->denominator).data(),
                        findings);
  }
  const std::size_t unused_rows = unused(plan->u, u);
  const std::size_t unused_columns = unused(plan->v, v);
  findings.unused_points = unused_rows * net.columns + (net.rows - unused_rows) * unused_columns;
  return findings;
}

}  // namespace patchproof
