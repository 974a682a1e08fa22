#include <patchproof/net/bezier_weights.hpp>

namespace patchproof {

namespace {

using Row = std::vector<Rational>;

/// The rows of the identity matrix: points as combinations of themselves.
std::vector<Row> unit_rows(std::size_t size) {
  std::vector<Row> rows(size, Row(size));
  for (std::size_t k = 0; k < size; ++k) rows[k][k] = 1;
  return rows;
}

/// first becomes (1 - t)*first + t*second.
void interpolate(Row& first, const Row& second, const Rational& t) {
  const Rational rest = Rational{1} - t;
  for (std::size_t k = 0; k < first.size(); ++k) first[k] = rest * first[k] + t * second[k];
}

}  // namespace

std::vector<Rational> bezier_weights(const KnotVector& knots, std::size_t span) {
  const auto p = static_cast<std::size_t>(knots.degree());
  const std::size_t k = knots.knot_of_span(span);
  const std::vector<Rational>& t = knots.knots();
  std::vector<Rational> weights;
  for (std::size_t r = 0; r <= p; ++r) {
    std::vector<Row> rows = unit_rows(p + 1);
    for (std::size_t level = 1; level <= p; ++level) {
      const Rational& x = level <= p - r ? t[k] : t[k + 1];
      for (std::size_t a = 0; a + level <= p; ++a) {
        // Between d[i-1] and d[i] of this level, i = k - p + level + a.
        const Rational& left = t[k - p + level + a];
        const Rational& right = t[k + a + 1];
        interpolate(rows[a], rows[a + 1], (x - left) / (right - left));
      }
    }
    weights.insert(weights.end(), rows[0].begin(), rows[0].end());
  }
  return weights;
}

std::vector<Rational> control_weights(const KnotVector& knots, std::size_t span, std::size_t i) {
  const auto p = static_cast<std::size_t>(knots.degree());
  std::vector<Row> rows = unit_rows(p + 1);
  for (std::size_t level = 1; level <= p; ++level) {
    const Rational x = (knots.knots()[i + level] - knots.begin_of(span)) / knots.length_of(span);
    for (std::size_t r = 0; r + level <= p; ++r) interpolate(rows[r], rows[r + 1], x);
  }
  return rows[0];
}

}  // namespace patchproof
