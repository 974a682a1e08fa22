#pragma once

#include <array>
#include <utility>

#include <patchproof/net/knot_vector.hpp>
#include <patchproof/net/strip_weights.hpp>

namespace patchproof {

/// Two derivatives across a seam that differ: the spans of the segment before, the order, the Bézier
/// coefficient along the seam, the coordinate, and both differences of Bézier points of this order.
template <typename Number>
struct Difference {
  std::size_t u_span;
  std::size_t v_span;
  int order;
  std::size_t coefficient;
  std::size_t coordinate;
  Number before;
  Number behind;
};

/// Bézier segments strip by strip, over common denominators: numbers of a strip are to be divided by
/// that of the net, of the span in u and of the span in v. The Number is exact as long as it does
/// not overflow, which whoever uses this has to know.
template <typename Number>
class StripConversion {
 public:
  /// `points`: the numerators of the net, row by row, `columns` points of `dimension` in a row. All
  /// of it has to live as long.
  StripConversion(const Number* points, std::size_t columns, std::size_t dimension,
                  const StripWeights<Number>& u, const StripWeights<Number>& v)
      : points_{points}, row_{columns * dimension}, dimension_{dimension}, u_{u}, v_{v},
        line_{v.spans() * (v.degree + 1) * dimension},
        rows_(row_), strip_((u.degree + 1) * line_), before_(strip_.size()) {}

  /// Goes to this strip; the one before stays known.
  void convert(std::size_t s) {
    std::swap(strip_, before_);
    const std::size_t p = u_.degree;
    const Number* weights = u_.weights_of(s);
    const Number* from = points_ + u_.first[s] * row_;
    for (std::size_t k = 0; k <= p; ++k) {
      combine(weights + k * (p + 1), p + 1, from, row_, row_, rows_.data());
      convert_row(rows_.data(), strip_.data() + k * line_);
    }
  }

  const Number& at(std::size_t t, std::size_t k, std::size_t l, std::size_t c) const {
    return strip_[k * line_ + (t * (v_.degree + 1) + l) * dimension_ + c];
  }

  /// Compares strip s, the present one, with the one before along their seam.
  template <typename Differ>
  void compare_with_last(std::size_t s, const Differ& differ) {
    const std::size_t p = u_.degree;
    const auto& seam = u_.seams[s - 1];
    for (int order = 0; order <= seam.order; ++order) {
      const auto r = static_cast<std::size_t>(order);
      const std::array<Number, highest_net_degree + 1> signs = alternating(r);
      for (std::size_t e = 0; e < line_; ++e) {
        Number before{};
        Number behind{};
        for (std::size_t i = 0; i <= r; ++i) {
          before += signs[i] * before_[(p - i) * line_ + e];
          behind += signs[i] * strip_[(r - i) * line_ + e];
        }
        if (before * seam.before[r] == behind * seam.behind[r]) continue;
        const std::size_t point = e / dimension_;
        differ(Difference<Number>{s - 1, point / (v_.degree + 1), order, point % (v_.degree + 1),
                                  e % dimension_, before, behind});
      }
    }
  }

  /// Compares the segments of strip s with each other along their seams.
  template <typename Differ>
  void compare_inside(std::size_t s, const Differ& differ) {
    const std::size_t q = v_.degree;
    for (std::size_t t = 0; t + 1 < v_.spans(); ++t) {
      const auto& seam = v_.seams[t];
      for (std::size_t k = 0; k <= u_.degree; ++k) {
        const Number* last = strip_.data() + k * line_ + (t * (q + 1) + q) * dimension_;
        for (std::size_t c = 0; c < dimension_; ++c) compare(s, t, k, c, last, seam, differ);
      }
    }
  }

  /// Calculates back the control points that this strip has and none before, from the segments, and
  /// compares them with those of the net. False when some are different.
  bool leads_back(std::size_t s) {
    bool equal = true;
    for (const auto& u_return : u_.back[s]) {
      combine(u_return.weights.data(), u_.degree + 1, strip_.data(), line_, line_, line());
      const Number* expected = points_ + u_return.control_point * row_;
      for (std::size_t t = 0; t < v_.spans(); ++t)
        for (const auto& v_return : v_.back[t])
          equal = leads_back(t, v_return, u_return.scale,
                             expected + v_return.control_point * dimension_) && equal;
    }
    return equal;
  }

 private:
  /// The sum of weights[a] * from[a*stride + e], for each e.
  static void combine(const Number* weights, std::size_t count, const Number* from,
                      std::size_t stride, std::size_t size, Number* to) {
    for (std::size_t e = 0; e < size; ++e) to[e] = weights[0] * from[e];
    for (std::size_t a = 1; a < count; ++a) {
      // Many weights at the ends of clamped splines are 0.
      if (weights[a] == Number{}) continue;
      const Number weight = weights[a];
      const Number* row = from + a * stride;
      for (std::size_t e = 0; e < size; ++e) to[e] += weight * row[e];
    }
  }

  /// The Bézier points of all spans in v, from a row of control points.
  void convert_row(const Number* row, Number* to) const {
    const std::size_t q = v_.degree;
    for (std::size_t t = 0; t < v_.spans(); ++t) {
      const Number* weights = v_.weights_of(t);
      const Number* from = row + v_.first[t] * dimension_;
      for (std::size_t l = 0; l <= q; ++l, weights += q + 1, to += dimension_)
        combine(weights, q + 1, from, dimension_, dimension_, to);
    }
  }

  /// (-1)^i binomial(r, i)
  static std::array<Number, highest_net_degree + 1> alternating(std::size_t r) {
    std::array<Number, highest_net_degree + 1> signs{};
    std::int64_t value = 1;
    for (std::size_t i = 0; i <= r; ++i) {
      signs[i] = Number{i % 2 == 0 ? value : -value};
      value = value * static_cast<std::int64_t>(r - i) / static_cast<std::int64_t>(i + 1);
    }
    return signs;
  }

  /// One coordinate across a seam in v: differences of last[0], last[-1], … and the points behind.
  template <typename Seam, typename Differ>
  void compare(std::size_t s, std::size_t t, std::size_t k, std::size_t c, const Number* last,
               const Seam& seam, const Differ& differ) {
    std::array<Number, highest_net_degree + 1> before;
    std::array<Number, highest_net_degree + 1> behind;
    const auto most = static_cast<std::size_t>(seam.order);
    for (std::size_t i = 0; i <= most; ++i) {
      before[i] = *(last - i * dimension_ + c);
      behind[i] = last[(i + 1) * dimension_ + c];
    }
    for (std::size_t r = 0; r <= most; ++r) {
      // before[i] and behind[i] are the r-th differences here, of points counted from the seam.
      if (!(before[0] * seam.before[r] == behind[0] * seam.behind[r]))
        differ(Difference<Number>{s, t, static_cast<int>(r), k, c, before[0], behind[0]});
      for (std::size_t i = 0; i + r < most; ++i) {
        before[i] = before[i] - before[i + 1];
        behind[i] = behind[i + 1] - behind[i];
      }
    }
  }

  template <typename Return>
  bool leads_back(std::size_t t, const Return& v_return, const Number& u_scale,
                  const Number* expected) const {
    const Number* from = line_of_.data() + t * (v_.degree + 1) * dimension_;
    const Number scale = u_scale * v_return.scale;
    for (std::size_t c = 0; c < dimension_; ++c) {
      Number sum = v_return.weights[0] * from[c];
      for (std::size_t l = 1; l <= v_.degree; ++l)
        sum += v_return.weights[l] * from[l * dimension_ + c];
      if (!(sum == scale * expected[c])) return false;
    }
    return true;
  }

  Number* line() {
    line_of_.resize(line_);
    return line_of_.data();
  }

  const Number* points_;
  /// Numbers in a row of the net.
  std::size_t row_;
  std::size_t dimension_;
  const StripWeights<Number>& u_;
  const StripWeights<Number>& v_;
  /// Numbers in a row of Bézier points of a strip.
  std::size_t line_;
  std::vector<Number> rows_;
  std::vector<Number> strip_;
  std::vector<Number> before_;
  /// Combinations of the rows of a strip.
  std::vector<Number> line_of_;
};

}  // namespace patchproof
