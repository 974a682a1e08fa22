// W5 and W6 with FLINT's integers and matrices of integers.
#include <flint/fmpz_mat.h>

#include "flint_jacobian.h"
#include "measure.h"

// W5. The energy of a net C is the sum of G[i,k] G[j,l] <C[i,j], C[k,l]>, where G has the integrals
// of products of derivatives of Bernstein polynomials; here times a whole number.
static void gram(fmpz_mat_t result, int n) {
  const ulong m = (ulong)(n - 1);
  fmpz_t common, a, b, entry;
  fmpz_init_set_ui(common, 1);
  fmpz_init(a);
  fmpz_init(b);
  fmpz_init(entry);
  for (ulong k = 0; k <= 2 * m; ++k) {
    fmpz_bin_uiui(a, 2 * m, k);
    fmpz_lcm(common, common, a);
  }
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k) {
      fmpz_zero(entry);
      for (int s = 0; s < 2; ++s)
        for (int t = 0; t < 2; ++t) {
          const int p = i - s, q = k - t;
          if (p < 0 || p > (int)m || q < 0 || q > (int)m) continue;
          fmpz_bin_uiui(a, 2 * m, (ulong)(p + q));
          fmpz_divexact(b, common, a);
          fmpz_bin_uiui(a, m, (ulong)p);
          fmpz_mul(b, b, a);
          fmpz_bin_uiui(a, m, (ulong)q);
          if (s == t) {
            fmpz_addmul(entry, b, a);
          } else {
            fmpz_submul(entry, b, a);
          }
        }
      fmpz_set(fmpz_mat_entry(result, i, k), entry);
    }
  fmpz_clear(common);
  fmpz_clear(a);
  fmpz_clear(b);
  fmpz_clear(entry);
}

// Adds factor * (point a, b) to the net's point (i, j): all points beside each other in one matrix.
static void add(fmpz_mat_t nets, slong factor, int n, int i, int j, int a, int b) {
  int k = 0;
  if (b == 0)
    k = a;
  else if (b == n)
    k = n + 1 + a;
  else
    k = 2 * n + 1 + b + (a == n ? n - 1 : 0);
  fmpz* entry = fmpz_mat_entry(nets, i, k * (n + 1) + j);
  fmpz_add_si(entry, entry, factor);
}

static void discrete_coons(fmpz_mat_t nets, int n, int mutant) {
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      add(nets, n * (n - j), n, i, j, i, 0);
      add(nets, n * j, n, i, j, i, n);
      add(nets, n * (n - i), n, i, j, 0, j);
      add(nets, n * i, n, i, j, n, j);
      add(nets, -(n - i) * (n - j), n, i, j, 0, 0);
      add(nets, -i * (n - j), n, i, j, n, 0);
      add(nets, -(n - i) * j, n, i, j, 0, n);
      add(nets, -i * j, n, i, j, n, n);
      if (i == 1 && j == 1) add(nets, mutant, n, i, j, 0, 1);
    }
}

// The matrix of inner points, by elimination without fractions: all leading minors are positive.
static int positive_definite(const fmpz_mat_t g, int n) {
  const int size = n - 1;
  fmpz_mat_t m;
  fmpz_t before;
  fmpz_mat_init(m, size, size);
  fmpz_init_set_ui(before, 1);
  for (int i = 0; i < size; ++i)
    for (int k = 0; k < size; ++k)
      fmpz_set(fmpz_mat_entry(m, i, k), fmpz_mat_entry(g, i + 1, k + 1));
  int positive = 1;
  for (int p = 0; p < size && positive; ++p) {
    const fmpz* pivot = fmpz_mat_entry(m, p, p);
    positive = fmpz_sgn(pivot) > 0;
    for (int i = p + 1; i < size && positive; ++i)
      for (int k = size - 1; k >= p; --k) {
        fmpz* entry = fmpz_mat_entry(m, i, k);
        fmpz_mul(entry, entry, pivot);
        fmpz_submul(entry, fmpz_mat_entry(m, i, p), fmpz_mat_entry(m, p, k));
        fmpz_divexact(entry, entry, before);
      }
    fmpz_set(before, pivot);
  }
  fmpz_mat_clear(m);
  fmpz_clear(before);
  return positive;
}

// The Hessian is the Kronecker square of the inner part of G; the gradient at an inner point is an
// entry of G C G.
static int w5(int n, int mutant) {
  const int points = 4 * n, inner = n - 1;
  fmpz_mat_t g, rows, columns, nets, half, turned, gradient;
  fmpz_mat_init(g, n + 1, n + 1);
  fmpz_mat_init(rows, inner, n + 1);
  fmpz_mat_init(columns, n + 1, inner);
  fmpz_mat_init(nets, n + 1, points * (n + 1));
  fmpz_mat_init(half, inner, points * (n + 1));
  fmpz_mat_init(turned, inner * points, n + 1);
  fmpz_mat_init(gradient, inner * points, inner);
  gram(g, n);
  for (int i = 1; i < n; ++i)
    for (int k = 0; k <= n; ++k) {
      fmpz_set(fmpz_mat_entry(rows, i - 1, k), fmpz_mat_entry(g, i, k));
      fmpz_set(fmpz_mat_entry(columns, k, i - 1), fmpz_mat_entry(g, i, k));
    }
  discrete_coons(nets, n, mutant);
  fmpz_mat_mul(half, rows, nets);
  for (int i = 0; i < inner; ++i)
    for (int k = 0; k < points; ++k)
      for (int j = 0; j <= n; ++j)
        fmpz_swap(fmpz_mat_entry(turned, i * points + k, j),
                  fmpz_mat_entry(half, i, k * (n + 1) + j));
  fmpz_mat_mul(gradient, turned, columns);
  const int convex = positive_definite(g, n);
  const int least = convex && fmpz_mat_is_zero(gradient);
  fmpz_mat_clear(g);
  fmpz_mat_clear(rows);
  fmpz_mat_clear(columns);
  fmpz_mat_clear(nets);
  fmpz_mat_clear(half);
  fmpz_mat_clear(turned);
  fmpz_mat_clear(gradient);
  return least;
}

int main(int argc, char** argv) {
  const struct Workload all[] = {{"W5", w5}, {"W6", w6}, {NULL, NULL}};
  // The last argument is where the nets of W6 are.
  data_folder = argc == 5 ? argv[4] : "";
  return measure_named(all, argc == 5 ? 4 : argc, argv);
}
