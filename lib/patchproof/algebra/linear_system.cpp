#include <patchproof/algebra/linear_system.hpp>

#include <optional>

namespace patchproof {

namespace {

// The row from `first` on with the best pivot in the column: a number if there is one.
std::optional<std::size_t> pivot_row(const std::vector<LinearEquation>& rows, std::size_t first,
                                     std::size_t column) {
  std::optional<std::size_t> best;
  for (std::size_t r = first; r < rows.size(); ++r) {
    const Fraction& entry = rows[r].coefficients[column];
    if (entry.is_zero()) continue;
    if (entry.is_polynomial() && entry.numerator().is_constant()) return r;
    if (!best ||
        entry.numerator().terms().size() < rows[*best].coefficients[column].numerator().terms().size())
      best = r;
  }
  return best;
}

}  // namespace

LinearSolution solution(std::vector<LinearEquation> rows, std::size_t unknowns, Budget& budget) {
  LinearSolution result;
  std::vector<std::optional<std::size_t>> row_of(unknowns);
  std::size_t next = 0;
  for (std::size_t column = 0; column < unknowns && next < rows.size(); ++column) {
    const std::optional<std::size_t> found = pivot_row(rows, next, column);
    if (!found) continue;
    std::swap(rows[next], rows[*found]);
    LinearEquation& pivot = rows[next];
    const Fraction divisor = pivot.coefficients[column];
    if (!divisor.numerator().is_constant()) result.pivots.push_back(divisor.numerator());
    for (Fraction& entry : pivot.coefficients)
      if (!entry.is_zero()) entry = quotient(entry, divisor, budget);
    pivot.right = quotient(pivot.right, divisor, budget);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const Fraction factor = rows[r].coefficients[column];
      if (r == next || factor.is_zero()) continue;
      for (std::size_t c = 0; c < unknowns; ++c) {
        if (pivot.coefficients[c].is_zero()) continue;
        rows[r].coefficients[c] = difference(
            rows[r].coefficients[c], product(factor, pivot.coefficients[c], budget), budget);
      }
      rows[r].right = difference(rows[r].right, product(factor, pivot.right, budget), budget);
    }
    row_of[column] = next++;
  }
  for (std::size_t r = next; r < rows.size(); ++r)
    if (!rows[r].right.is_zero()) result.contradictions.push_back(rows[r].right);
  for (std::size_t column = 0; column < unknowns; ++column)
    if (!row_of[column]) result.free.push_back(column);
  for (std::size_t column = 0; column < unknowns; ++column) {
    std::vector<Fraction> factors;
    for (const std::size_t f : result.free) {
      if (!row_of[column])
        factors.push_back(Rational{f == column ? 1 : 0});
      else
        factors.push_back(
            product(rows[*row_of[column]].coefficients[f], Rational{-1}, budget));
    }
    result.constant_part.push_back(row_of[column] ? rows[*row_of[column]].right : Fraction{});
    result.factors.push_back(std::move(factors));
  }
  return result;
}

}  // namespace patchproof
