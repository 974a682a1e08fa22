// W6 of flint_matrix.c: the Jacobian of a plane patch is positive on the unit square, by
// subdivision of its Bernstein form. Everything is times a positive whole number, so there are no
// fractions.
#pragma once

#include <flint/fmpz_vec.h>
#include <stdio.h>
#include <stdlib.h>

// Where the nets are.
static const char* data_folder;

// The two coordinates of a net of the plane, row by row.
static fmpz* read_net(int n, int mutant) {
  static fmpz* nets[2];
  static int sizes[2];
  if (nets[mutant] != NULL && sizes[mutant] == n) return nets[mutant];
  char name[4096];
  snprintf(name, sizeof name, "%s/W6_%d_%s.txt", data_folder, n, mutant ? "mutant" : "true");
  FILE* file = fopen(name, "r");
  if (file == NULL) exit(66);
  nets[mutant] = _fmpz_vec_init(2 * (n + 1) * (n + 1));
  sizes[mutant] = n;
  for (int k = 0; k < 2 * (n + 1) * (n + 1); ++k)
    if (fmpz_fread(file, nets[mutant] + k) <= 0) exit(66);
  fclose(file);
  return nets[mutant];
}

// result[i, j] += sign * (sum of scaled differences in u of a) * (in v of b).
static void add_product(fmpz* result, int n, const fmpz* a, const fmpz* b, int sign) {
  const int side = 2 * n;
  fmpz_t p, choose;
  fmpz_init(p);
  fmpz_init(choose);
  fmpz* right = _fmpz_vec_init((n + 1) * n);
  for (int k = 0; k <= n; ++k)
    for (int l = 0; l < n; ++l) {
      fmpz* entry = right + k * n + l;
      fmpz_sub(entry, b + k * (n + 1) + l + 1, b + k * (n + 1) + l);
      fmpz_bin_uiui(choose, (ulong)n, (ulong)k);
      fmpz_mul(entry, entry, choose);
      fmpz_bin_uiui(choose, (ulong)(n - 1), (ulong)l);
      fmpz_mul(entry, entry, choose);
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= n; ++j) {
      fmpz_sub(p, a + (i + 1) * (n + 1) + j, a + i * (n + 1) + j);
      fmpz_bin_uiui(choose, (ulong)(n - 1), (ulong)i);
      fmpz_mul(p, p, choose);
      fmpz_bin_uiui(choose, (ulong)n, (ulong)j);
      fmpz_mul(p, p, choose);
      if (sign < 0) fmpz_neg(p, p);
      for (int k = 0; k <= n; ++k)
        _fmpz_vec_scalar_addmul_fmpz(result + (i + k) * side + j, right + k * n, n, p);
    }
  _fmpz_vec_clear(right, (n + 1) * n);
  fmpz_clear(p);
  fmpz_clear(choose);
}

// All Bernstein coefficients of the Jacobian, times one number.
static void jacobian(fmpz* result, int n, const fmpz* net) {
  const int side = 2 * n;
  const fmpz* y = net + (n + 1) * (n + 1);
  add_product(result, n, net, y, 1);
  add_product(result, n, y, net, -1);
  fmpz_t common, choose;
  fmpz_init_set_ui(common, 1);
  fmpz_init(choose);
  fmpz* weights = _fmpz_vec_init(side);
  for (int i = 0; i < side; ++i) {
    fmpz_bin_uiui(weights + i, (ulong)(side - 1), (ulong)i);
    fmpz_lcm(common, common, weights + i);
  }
  for (int i = 0; i < side; ++i) fmpz_divexact(weights + i, common, weights + i);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      fmpz_mul(result + i * side + j, result + i * side + j, weights + i);
      fmpz_mul(result + i * side + j, result + i * side + j, weights + j);
    }
  _fmpz_vec_clear(weights, side);
  fmpz_clear(common);
  fmpz_clear(choose);
}

// De Casteljau at 1/2 along one line of coefficients, which becomes the first half; no division, so
// everything becomes 2^(side - 1) times as large.
static void halve(fmpz* line, fmpz* second, int side, int step) {
  for (int k = 0; k < side; ++k) {
    fmpz_mul_2exp(second + (side - 1 - k) * step, line + (side - 1) * step, (ulong)(side - 1 - k));
    for (int i = side - 1; i > k; --i)
      fmpz_add(line + i * step, line + (i - 1) * step, line + i * step);
  }
  for (int k = 0; k < side; ++k)
    fmpz_mul_2exp(line + k * step, line + k * step, (ulong)(side - 1 - k));
}

static int positive(fmpz* box, int side, int depth) {
  int all = 1;
  for (int k = 0; k < side * side && all; ++k) all = fmpz_sgn(box + k) > 0;
  if (all) return 1;
  const int last = side - 1;
  if (fmpz_sgn(box) <= 0 || fmpz_sgn(box + last) <= 0 || fmpz_sgn(box + last * side) <= 0 ||
      fmpz_sgn(box + last * side + last) <= 0)
    return 0;
  if (depth == 40) return 0;
  fmpz* second = _fmpz_vec_init(side * side);
  for (int k = 0; k < side; ++k) {
    if (depth % 2 == 0)
      halve(box + k, second + k, side, side);
    else
      halve(box + k * side, second + k * side, side, 1);
  }
  const int both = positive(box, side, depth + 1) && positive(second, side, depth + 1);
  _fmpz_vec_clear(second, side * side);
  return both;
}

static int w6(int n, int mutant) {
  const fmpz* net = read_net(n, mutant);
  fmpz* box = _fmpz_vec_init(4 * n * n);
  jacobian(box, n, net);
  const int answer = positive(box, 2 * n, 0);
  _fmpz_vec_clear(box, 4 * n * n);
  return answer;
}
