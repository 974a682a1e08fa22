// W1, W2, W3 with FLINT's sparse polynomials over the integers.
#include "flint_patch.h"
#include "measure.h"

// n * n times the point (i, j) of the discrete Coons net; one factor of the mutant is wrong.
static void net_point(Poly result, int n, int i, int j, int mutant) {
  fmpz_mpoly_zero(result, ring);
  add_point(result, n * (n - j), n, i, 0);
  add_point(result, n * j, n, i, n);
  add_point(result, n * (n - i), n, 0, j);
  add_point(result, n * i, n, n, j);
  add_point(result, -(n - i) * (n - j), n, 0, 0);
  add_point(result, -i * (n - j), n, n, 0);
  add_point(result, -(n - i) * j, n, 0, n);
  add_point(result, -i * j, n, n, n);
  if (i == 1 && j == 1) add_point(result, mutant, n, 0, 1);
}

static int w1(int n, int mutant) {
  fmpz_mpoly_ctx_init(ring, 3, ORD_LEX);
  List p = new_list(7);
  fmpz_mpoly_gen(p, U, ring);
  fmpz_mpoly_gen(p + 1, V, ring);
  coons(p + 2, n, p, p + 1);
  fmpz_mpoly_scalar_mul_si(p + 2, p + 2, n * n, ring);
  List at_u = bernstein(n, p), at_v = bernstein(n, p + 1);
  for (int i = 0; i <= n; ++i) {
    fmpz_mpoly_zero(p + 4, ring);
    for (int j = 0; j <= n; ++j) {
      net_point(p + 5, n, i, j, mutant);
      fmpz_mpoly_mul(p + 6, p + 5, at_v + j, ring);
      fmpz_mpoly_add(p + 4, p + 4, p + 6, ring);
    }
    fmpz_mpoly_mul(p + 6, p + 4, at_u + i, ring);
    fmpz_mpoly_add(p + 3, p + 3, p + 6, ring);
  }
  const int equal = fmpz_mpoly_equal(p + 2, p + 3, ring);
  free_list(at_u, n + 1);
  free_list(at_v, n + 1);
  free_list(p, 7);
  fmpz_mpoly_ctx_clear(ring);
  return equal;
}

// The mutant has u^2 v^2 times one of the points too many.
static int w2(int n, int mutant) {
  fmpz_mpoly_ctx_init(ring, 3, ORD_LEX);
  List p = new_list(4);
  fmpz_mpoly_gen(p, U, ring);
  fmpz_mpoly_gen(p + 1, V, ring);
  coons(p + 2, n, p, p + 1);
  const ulong wrong[3] = {2, 2, point(n, 0, 1)};
  fmpz_mpoly_set_coeff_si_ui(p + 3, mutant, wrong, ring);
  fmpz_mpoly_add(p + 2, p + 2, p + 3, ring);
  const int variables[4] = {U, U, V, V};
  for (int k = 0; k < 4; ++k) fmpz_mpoly_derivative(p + 2, p + 2, variables[k], ring);
  const int zero = fmpz_mpoly_is_zero(p + 2, ring);
  free_list(p, 4);
  fmpz_mpoly_ctx_clear(ring);
  return zero;
}

// The patch over [a, b] x [c, d] is the Coons patch of its own edges. The mutant takes one corner
// from the wrong place.
static int w3(int n, int mutant) {
  fmpz_mpoly_ctx_init(ring, 7, ORD_LEX);
  List g = new_list(7), edges = new_list(4), corners = new_list(4), p = new_list(4);
  for (int k = 0; k < 7; ++k) fmpz_mpoly_gen(g + k, k, ring);
  between(p, g + U, g + A, g + B);
  between(p + 1, g + V, g + C, g + D);
  coons(p + 2, n, p, p + 1);
  coons(edges, n, p, g + C);
  coons(edges + 1, n, p, g + D);
  coons(edges + 2, n, g + A, p + 1);
  coons(edges + 3, n, g + B, p + 1);
  coons(corners, n, g + A, g + C);
  coons(corners + 1, n, g + B, g + C);
  coons(corners + 2, n, g + A, g + D);
  coons(corners + 3, n, mutant ? g + A : g + B, g + D);
  blended(p + 3, g + U, g + V, edges, corners);
  const int equal = fmpz_mpoly_equal(p + 2, p + 3, ring);
  free_list(g, 7);
  free_list(edges, 4);
  free_list(corners, 4);
  free_list(p, 4);
  fmpz_mpoly_ctx_clear(ring);
  return equal;
}

int main(int argc, char** argv) {
  const struct Workload all[] = {{"W1", w1}, {"W2", w2}, {"W3", w3}, {NULL, NULL}};
  return measure_named(all, argc, argv);
}
