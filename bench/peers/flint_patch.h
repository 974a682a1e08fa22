// Coons patches of boundary points as FLINT's sparse polynomials over the integers.
//
// The claims are linear in the control points. A linear form in them is held as a polynomial in one
// more variable x, the k-th point being x^k: nothing is lost, and monomials are short. Denominators
// are cleared by hand.
#pragma once

#include <flint/fmpz_mpoly.h>
#include <stdlib.h>

typedef fmpz_mpoly_t Poly;
typedef fmpz_mpoly_struct* List;

static fmpz_mpoly_ctx_t ring;
enum { U, V, X, A, B, C, D };  // the rectangle is [a, b] x [c, d]

static List new_list(int size) {
  List list = malloc(sizeof(fmpz_mpoly_struct) * (size_t)size);
  for (int i = 0; i < size; ++i) fmpz_mpoly_init(list + i, ring);
  return list;
}

static void free_list(List list, int size) {
  for (int i = 0; i < size; ++i) fmpz_mpoly_clear(list + i, ring);
  free(list);
}

// Numbers of the boundary points; inner points have none.
static ulong point(int n, int i, int j) {
  if (j == 0) return (ulong)i;
  if (j == n) return (ulong)(n + 1 + i);
  return (ulong)(2 * n + 1 + j) + (i == n ? (ulong)(n - 1) : 0);
}

// sum += factor * (point i, j)
static void add_point(Poly sum, slong factor, int n, int i, int j) {
  ulong exponents[7] = {0};
  exponents[X] = point(n, i, j);
  fmpz_t old;
  fmpz_init(old);
  fmpz_mpoly_get_coeff_fmpz_ui(old, sum, exponents, ring);
  fmpz_add_si(old, old, factor);
  fmpz_mpoly_set_coeff_fmpz_ui(sum, old, exponents, ring);
  fmpz_clear(old);
}

// All Bernstein polynomials of degree n in t.
static List bernstein(int n, const Poly t) {
  List result = new_list(n + 1), up = new_list(n + 1), down = new_list(n + 1);
  Poly rest;
  fmpz_t choose;
  fmpz_mpoly_init(rest, ring);
  fmpz_init(choose);
  fmpz_mpoly_neg(rest, t, ring);
  fmpz_mpoly_add_si(rest, rest, 1, ring);
  fmpz_mpoly_one(up, ring);
  fmpz_mpoly_one(down, ring);
  for (int i = 1; i <= n; ++i) {
    fmpz_mpoly_mul(up + i, up + i - 1, t, ring);
    fmpz_mpoly_mul(down + i, down + i - 1, rest, ring);
  }
  for (int i = 0; i <= n; ++i) {
    fmpz_mpoly_mul(result + i, up + i, down + n - i, ring);
    fmpz_bin_uiui(choose, (ulong)n, (ulong)i);
    fmpz_mpoly_scalar_mul_fmpz(result + i, result + i, choose, ring);
  }
  fmpz_clear(choose);
  fmpz_mpoly_clear(rest, ring);
  free_list(up, n + 1);
  free_list(down, n + 1);
  return result;
}

// The Bézier curve of the points (i0, j0), (i0 + di, j0 + dj), …
static void curve(Poly result, int n, const List basis, int i0, int j0, int di, int dj) {
  Poly one, product;
  fmpz_mpoly_init(one, ring);
  fmpz_mpoly_init(product, ring);
  fmpz_mpoly_zero(result, ring);
  for (int k = 0; k <= n; ++k) {
    fmpz_mpoly_zero(one, ring);
    add_point(one, 1, n, i0 + k * di, j0 + k * dj);
    fmpz_mpoly_mul(product, basis + k, one, ring);
    fmpz_mpoly_add(result, result, product, ring);
  }
  fmpz_mpoly_clear(one, ring);
  fmpz_mpoly_clear(product, ring);
}

// result = (1 - t) * a + t * b
static void between(Poly result, const Poly t, const Poly a, const Poly b) {
  Poly change;
  fmpz_mpoly_init(change, ring);
  fmpz_mpoly_sub(change, b, a, ring);
  fmpz_mpoly_mul(change, change, t, ring);
  fmpz_mpoly_add(result, a, change, ring);
  fmpz_mpoly_clear(change, ring);
}

// The Coons patch at (s, t) of its edges there and its corners 00, 10, 01, 11.
static void blended(Poly result, const Poly s, const Poly t, const List edges, const List corners) {
  List part = new_list(4);
  between(part, t, edges, edges + 1);
  between(part + 1, s, edges + 2, edges + 3);
  between(part + 2, s, corners, corners + 1);
  between(part + 3, s, corners + 2, corners + 3);
  between(part + 2, t, part + 2, part + 3);
  fmpz_mpoly_add(result, part, part + 1, ring);
  fmpz_mpoly_sub(result, result, part + 2, ring);
  free_list(part, 4);
}

// The Coons patch of the boundary points at (s, t).
static void coons(Poly result, int n, const Poly s, const Poly t) {
  List at_s = bernstein(n, s), at_t = bernstein(n, t), edges = new_list(4), corners = new_list(4);
  curve(edges, n, at_s, 0, 0, 1, 0);
  curve(edges + 1, n, at_s, 0, n, 1, 0);
  curve(edges + 2, n, at_t, 0, 0, 0, 1);
  curve(edges + 3, n, at_t, n, 0, 0, 1);
  for (int k = 0; k < 4; ++k) add_point(corners + k, 1, n, k % 2 * n, k / 2 * n);
  blended(result, s, t, edges, corners);
  free_list(at_s, n + 1);
  free_list(at_t, n + 1);
  free_list(edges, 4);
  free_list(corners, 4);
}
