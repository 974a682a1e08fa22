#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <patchproof/net/knot_vector.hpp>
#include <patchproof/net/strip_weights.hpp>

namespace patchproof {

/// Two derivatives across a seam that differ: the spans of the segment before, the order, the
/// Bézier coefficient along the seam, the coordinate, and both differences of Bézier points of this
/// order.
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

/// Bézier segments strip by strip, over common denominators: numbers of a strip are to be divided
/// by that of the net, of the span in u and of the span in v. The Number is exact as long as it
/// does not overflow, which whoever uses this has to know.
template <typename Number>
class StripConversion {
 public:
  /// `points`: the numerators of the net, row by row, `columns` points of `dimension` in a row. All
  /// of it has to live as long.
  StripConversion(const Number* points, std::size_t columns, std::size_t dimension,
                  const StripWeights<Number>& u, const StripWeights<Number>& v)
      : points_{points},
        row_{columns * dimension},
        dimension_{dimension},
        u_{u},
        v_{v},
        line_{v.spans() * (v.degree + 1) * dimension},
        rows_(row_),
        strip_((u.degree + 1) * line_),
        before_(strip_.size()) {}

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
      difference(r, before_.data() + p * line_, -static_cast<std::ptrdiff_t>(line_), differences_);
      difference(r, strip_.data() + r * line_, -static_cast<std::ptrdiff_t>(line_), behind_);
      for (std::size_t e = 0; e < line_; ++e) {
        if (differences_[e] * seam.before[r] == behind_[e] * seam.behind[r]) continue;
        const std::size_t point = e / dimension_;
        differ(Difference<Number>{s - 1, point / (v_.degree + 1), order, point % (v_.degree + 1),
                                  e % dimension_, differences_[e], behind_[e]});
      }
    }
  }

  /// Compares the segments of strip s with each other along their seams.
  template <typename Differ>
  void compare_inside(std::size_t s, const Differ& differ) {
    with_sizes([&](auto q, auto dimension) {
      for (std::size_t k = 0; k <= u_.degree; ++k) {
        const Number* last = strip_.data() + k * line_ + q * dimension;
        for (std::size_t t = 0; t + 1 < v_.spans(); ++t, last += (q + 1) * dimension)
          for (std::size_t c = 0; c < dimension; ++c)
            compare(Place{s, t, k, c}, last + c, dimension, differ);
      }
    });
  }

  /// Calculates back the control points that this strip has and none before, from the segments, and
  /// compares them with those of the net. False when some are different.
  bool leads_back(std::size_t s) {
    bool equal = true;
    for (const auto& u_return : u_.back[s]) {
      combine(u_return.weights.data(), u_.degree + 1, strip_.data(), line_, line_, line());
      const Number* expected = points_ + u_return.control_point * row_;
      with_sizes([&](auto q, auto dimension) {
        const Number* from = line_of_.data();
        for (std::size_t t = 0; t < v_.spans(); ++t, from += (q + 1) * dimension)
          for (const auto& v_return : v_.back[t])
            equal = leads_back(from, v_return.weights.data(), u_return.scale * v_return.scale,
                               expected + v_return.control_point * dimension, q, dimension) &&
                    equal;
      });
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

  /// Calls work(q, dimension) for the degree in v and the dimension: in the usual case with
  /// constants, so that loops of three or four rounds are none.
  template <typename Work>
  void with_sizes(const Work& work) const {
    using Three = std::integral_constant<std::size_t, 3>;
    if (v_.degree == 3 && dimension_ == 3)
      work(Three{}, Three{});
    else
      work(v_.degree, dimension_);
  }

  /// The Bézier points of all spans in v, from a row of control points.
  void convert_row(const Number* row, Number* to) const {
    with_sizes([&](auto q, auto dimension) {
      const Number* weights = v_.weights.data();
      for (const std::size_t first : v_.first) {
        const Number* from = row + first * dimension;
        for (std::size_t l = 0; l <= q; ++l, weights += q + 1, to += dimension) {
          for (std::size_t c = 0; c < dimension; ++c) {
            Number sum = weights[0] * from[c];
            for (std::size_t b = 1; b <= q; ++b) sum += weights[b] * from[b * dimension + c];
            to[c] = sum;
          }
        }
      }
    });
  }

  /// The r-th difference of lines, the sum of (-1)^i binomial(r, i) * from[i*stride + e].
  void difference(std::size_t r, const Number* from, std::ptrdiff_t stride,
                  std::vector<Number>& to) const {
    to.assign(from, from + line_);
    std::int64_t binomial = 1;
    for (std::size_t i = 1; i <= r; ++i) {
      binomial = -binomial * static_cast<std::int64_t>(r - i + 1) / static_cast<std::int64_t>(i);
      const Number factor{binomial};
      const Number* line = from + static_cast<std::ptrdiff_t>(i) * stride;
      for (std::size_t e = 0; e < line_; ++e) to[e] += factor * line[e];
    }
  }

  /// One coordinate of row k of strip s across the seam behind span t.
  struct Place {
    std::size_t s;
    std::size_t t;
    std::size_t k;
    std::size_t c;
  };

  /// Differences of last[0], last[-step], … with those of the points behind. With two the usual
  /// order is a constant.
  template <typename Step, typename Differ>
  void compare(const Place& place, const Number* last, Step step, const Differ& differ) const {
    const auto& seam = v_.seams[place.t];
    if (seam.order == 2)
      compare(place, last, step, std::integral_constant<std::size_t, 2>{}, seam, differ);
    else
      compare(place, last, step, static_cast<std::size_t>(seam.order), seam, differ);
  }

  template <typename Step, typename Order, typename Seam, typename Differ>
  static void compare(const Place& place, const Number* last, Step step, Order most,
                      const Seam& seam, const Differ& differ) {
    std::array<Number, highest_net_degree + 1> before;
    std::array<Number, highest_net_degree + 1> behind;
    for (std::size_t i = 0; i <= most; ++i) {
      before[i] = *(last - i * step);
      behind[i] = last[(i + 1) * step];
    }
    for (std::size_t r = 0; r <= most; ++r) {
      // before[i] and behind[i] are the r-th differences here, of points counted from the seam.
      if (!(before[0] * seam.before[r] == behind[0] * seam.behind[r]))
        differ(Difference<Number>{place.s, place.t, static_cast<int>(r), place.k, place.c,
                                  before[0], behind[0]});
      for (std::size_t i = 0; i + r < most; ++i) {
        before[i] = before[i] - before[i + 1];
        behind[i] = behind[i + 1] - behind[i];
      }
    }
  }

  template <typename Degree, typename Dimension>
  static bool leads_back(const Number* from, const Number* weights, const Number& scale,
                         const Number* expected, Degree q, Dimension dimension) {
    bool equal = true;
    for (std::size_t c = 0; c < dimension; ++c) {
      Number sum = weights[0] * from[c];
      for (std::size_t l = 1; l <= q; ++l) sum += weights[l] * from[l * dimension + c];
      equal = sum == scale * expected[c] && equal;
    }
    return equal;
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
  /// Combinations of the rows of a strip, and their differences at a seam.
  std::vector<Number> line_of_;
  std::vector<Number> differences_;
  std::vector<Number> behind_;
};

}  // namespace patchproof
