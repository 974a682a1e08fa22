// W5 with GiNaC's matrices and numbers.
#include <ginac/ginac.h>

#include <vector>

#include "measure.h"

using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::numeric;
using GiNaC::symbol;

namespace {

/// The boundary points of a net, made once: naming symbols is no part of the proof.
const std::vector<std::vector<ex>>& net_of(int n) {
  static std::vector<std::vector<ex>> net;
  if (net.empty())
    for (int i = 0; i <= n; ++i) {
      net.emplace_back();
      for (int j = 0; j <= n; ++j)
        net.back().push_back(i % n == 0 || j % n == 0 ? ex{symbol{}} : ex{0});
    }
  return net;
}

/// Integrals of products of derivatives of Bernstein polynomials, times the same number.
matrix gram(int n) {
  const int m = n - 1;
  const auto product = [m](int p, int q) -> numeric {
    if (p < 0 || q < 0 || p > m || q > m) return 0;
    return GiNaC::binomial(numeric{m}, numeric{p}) * GiNaC::binomial(numeric{m}, numeric{q}) /
           GiNaC::binomial(numeric{2 * m}, numeric{p + q});
  };
  matrix result(static_cast<unsigned>(n + 1), static_cast<unsigned>(n + 1));
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k)
      result(static_cast<unsigned>(i), static_cast<unsigned>(k)) =
          product(i - 1, k - 1) + product(i, k) - product(i - 1, k) - product(i, k - 1);
  return result;
}

/// Of the inner part: by elimination, all pivots are positive.
bool definite(const matrix& g, int n) {
  std::vector<std::vector<numeric>> r;
  for (int i = 1; i < n; ++i) {
    r.emplace_back();
    for (int k = 1; k < n; ++k)
      r.back().push_back(
          GiNaC::ex_to<numeric>(g(static_cast<unsigned>(i), static_cast<unsigned>(k))));
  }
  for (std::size_t p = 0; p < r.size(); ++p) {
    if (!r[p][p].is_positive()) return false;
    for (std::size_t i = p + 1; i < r.size(); ++i) {
      const numeric factor = r[i][p] / r[p][p];
      for (std::size_t k = p; k < r.size(); ++k) r[i][k] -= factor * r[p][k];
    }
  }
  return true;
}

/// A point of the discrete Coons net; one factor of the mutant is wrong.
ex net_point(const std::vector<std::vector<ex>>& v, int n, int i, int j, int mutant) {
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
  const auto last = static_cast<std::size_t>(n);
  const numeric s{i, n}, t{j, n};
  ex sum = (1 - t) * v[a][0] + t * v[a][last] + (1 - s) * v[0][b] + s * v[last][b] -
           (1 - s) * (1 - t) * v[0][0] - s * (1 - t) * v[last][0] - (1 - s) * t * v[0][last] -
           s * t * v[last][last];
  if (i == 1 && j == 1) sum += numeric{mutant, n * n} * v[0][1];
  return sum;
}

/// The Hessian is the Kronecker square of the inner part of G, the gradient G C G at inner points.
int w5(int n, int mutant) {
  const auto& net = net_of(n);
  const auto size = static_cast<unsigned>(n + 1);
  const matrix g = gram(n);
  matrix c(size, size);
  for (unsigned i = 0; i < size; ++i)
    for (unsigned j = 0; j < size; ++j)
      c(i, j) = net_point(net, n, static_cast<int>(i), static_cast<int>(j), mutant);
  const auto inner = static_cast<unsigned>(n - 1);
  const matrix part = GiNaC::ex_to<matrix>(GiNaC::sub_matrix(g, 1, inner, 0, size));
  matrix half = part.mul(c);
  // Sums of the same points are put together before they are multiplied once more.
  for (unsigned i = 0; i < inner; ++i)
    for (unsigned j = 0; j < size; ++j) half(i, j) = half(i, j).expand();
  const matrix gradient = half.mul(part.transpose());
  bool zero = true;
  for (unsigned i = 0; i < inner; ++i)
    for (unsigned j = 0; j < inner; ++j) zero = zero && gradient(i, j).expand().is_zero();
  return definite(g, n) && zero;
}

}  // namespace

int main(int argc, char** argv) {
  const Workload all[] = {{"W5", w5}, {nullptr, nullptr}};
  return measure_named(all, argc, argv);
}
