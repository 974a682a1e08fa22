#include <recheck/basis.hpp>

namespace recheck {

namespace {

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients result(a.size() + b.size() - 1, Rational{0});
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  return result;
}

void add(Coefficients& to, const Coefficients& a) {
  if (to.size() < a.size()) to.resize(a.size(), Rational{0});
  for (std::size_t i = 0; i < a.size(); ++i) to[i] += a[i];
}

}  // namespace

Coefficients bernstein(std::size_t degree, std::size_t index) {
  if (index > degree) return {Rational{0}};
  Rational binomial = 1;
  for (std::size_t k = 1; k <= index; ++k) binomial = binomial * (degree - index + k) / k;
  Coefficients result{binomial};
  for (std::size_t k = 0; k < index; ++k) result = product(result, {0, 1});
  for (std::size_t k = index; k < degree; ++k) result = product(result, {1, -1});
  return result;
}

Coefficients bspline_basis(std::size_t degree, std::size_t index, std::size_t span,
                           const std::vector<Rational>& knots) {
  const Rational start = knots.at(span);
  const Rational length = knots.at(span + 1) - start;
  // row[k] is N_{index+k,p} for the degree p that was reached.
  std::vector<Coefficients> row;
  for (std::size_t k = 0; k <= degree; ++k) row.push_back({Rational{index + k == span ? 1 : 0}});
  for (std::size_t p = 1; p <= degree; ++p) {
    for (std::size_t k = 0; k + p <= degree; ++k) {
      const std::size_t i = index + k;
      const Rational rise = knots.at(i + p) - knots.at(i);
      const Rational fall = knots.at(i + p + 1) - knots.at(i + 1);
      Coefficients next;
      if (rise != 0) add(next, product({(start - knots.at(i)) / rise, length / rise}, row[k]));
      if (fall != 0)
        add(next, product({(knots.at(i + p + 1) - start) / fall, -length / fall}, row[k + 1]));
      row[k] = next.empty() ? Coefficients{Rational{0}} : next;
    }
  }
  return row.front();
}

}  // namespace recheck
