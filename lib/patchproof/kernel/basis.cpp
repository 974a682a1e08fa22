#include <patchproof/kernel/basis.hpp>

namespace patchproof {

std::vector<Rational> bernstein_coefficients(int degree, int index) {
  std::vector<Rational> result(static_cast<std::size_t>(degree) + 1, Rational{0});
  if (index < 0 || index > degree) return result;
  // C(n,i) t^i (1-t)^(n-i) = sum_k (-1)^(k-i) C(n,i) C(n-i,k-i) t^k
  Integer coefficient = 1;
  for (int k = 1; k <= index; ++k) coefficient = coefficient * (degree - k + 1) / k;
  for (int k = index; k <= degree; ++k) {
    result[static_cast<std::size_t>(k)] = Rational{coefficient};
    coefficient = -coefficient * (degree - k) / (k - index + 1);
  }
  return result;
}

std::vector<Rational> basis_coefficients(const BasisFunction& f) {
  const auto knot = [&](int i) -> const Rational& { return f.knots.at(static_cast<std::size_t>(i)); };
  const Rational start = knot(f.span);
  const Rational length = knot(f.span + 1) - start;
  const auto degree = static_cast<std::size_t>(f.degree);
  // pieces[i] = N_{index+i, p} for the current p, as coefficients in t.
  std::vector<std::vector<Rational>> pieces(degree + 1, std::vector<Rational>(degree + 1, 0));
  for (int i = 0; i <= f.degree; ++i)
    if (f.index + i == f.span) pieces[static_cast<std::size_t>(i)][0] = 1;
  // target += (a + b t) * piece
  const auto add = [&](std::vector<Rational>& target, const std::vector<Rational>& piece,
                       const Rational& a, const Rational& b) {
    for (std::size_t k = 0; k <= degree; ++k) {
      target[k] += a * piece[k];
      if (k < degree) target[k + 1] += b * piece[k];
    }
  };
  for (int p = 1; p <= f.degree; ++p) {
    for (int i = 0; i <= f.degree - p; ++i) {
      std::vector<Rational> next(degree + 1, 0);
      const int at = f.index + i;
      const Rational rise = knot(at + p) - knot(at);
      const Rational fall = knot(at + p + 1) - knot(at + 1);
      // x = start + length t;  (x - k_i)/(k_{i+p} - k_i) and (k_{i+p+1} - x)/(k_{i+p+1} - k_{i+1})
      if (rise != 0)
        add(next, pieces[static_cast<std::size_t>(i)], (start - knot(at)) / rise, length / rise);
      if (fall != 0)
        add(next, pieces[static_cast<std::size_t>(i) + 1], (knot(at + p + 1) - start) / fall,
            -length / fall);
      pieces[static_cast<std::size_t>(i)] = std::move(next);
    }
  }
  return pieces.front();
}

}  // namespace patchproof
