// W4 with FLINT's rational numbers: a clamped uniform bicubic net becomes the Bézier points of all
// its segments, and neighbours have equal first and second differences across every seam.
#include <flint/fmpq.h>

#include "measure.h"

static fmpq* new_numbers(long count) {
  fmpq* result = malloc(sizeof(fmpq) * (size_t)count);
  for (long k = 0; k < count; ++k) fmpq_init(result + k);
  return result;
}

static void free_numbers(fmpq* numbers, long count) {
  for (long k = 0; k < count; ++k) fmpq_clear(numbers + k);
  free(numbers);
}

// The net is given, so it is no part of the proof.
static const fmpq* given(int n) {
  static fmpq* net = NULL;
  if (net != NULL) return net;
  net = new_numbers(3L * n * n);
  for (long i = 0; i < n; ++i)
    for (long j = 0; j < n; ++j)
      for (long k = 0; k < 3; ++k)
        fmpq_set_si(net + (i * n + j) * 3 + k, (7 * i + 13 * j + 5 * k + i * j) % 101 - 50,
                    (ulong)(1 + (i + 2 * j + 3 * k) % 7));
  return net;
}

static long knot(long k, long last) { return k < 0 ? 0 : k > last ? last : k; }

// One line of n points, `step` numbers apart, to 3 (n - 3) + 1 points. The mutant has one wrong
// factor.
static void to_bezier(fmpq* b, const fmpq* d, int n, long to_step, long from_step, int mutant) {
  const long last = n - 3;
  fmpq_t factor, change, half;
  fmpq_init(factor);
  fmpq_init(change);
  fmpq_init(half);
  fmpq_set_si(half, 1, 2);
  fmpq_set(b, d);
  fmpq_set(b + 3 * last * to_step, d + (n - 1) * from_step);
  for (long k = 0; k < last; ++k) {
    const fmpq* p = d + (k + 1) * from_step;
    const fmpq* q = d + (k + 2) * from_step;
    const long begin = knot(k - 1, last), length = knot(k + 2, last) - begin;
    fmpq_sub(change, q, p);
    for (int side = 1; side < 3; ++side) {
      fmpq_set_si(factor, knot(k + side - 1, last) - begin, (ulong)length);
      if (mutant && k == 1 && side == 1) fmpq_set_si(factor, 1, 5);
      fmpq_mul(factor, factor, change);
      fmpq_add(b + (3 * k + side) * to_step, p, factor);
    }
  }
  for (long k = 1; k < last; ++k) {
    fmpq* middle = b + 3 * k * to_step;
    fmpq_add(middle, middle - to_step, middle + to_step);
    fmpq_mul(middle, middle, half);
  }
  fmpq_clear(factor);
  fmpq_clear(change);
  fmpq_clear(half);
}

// Whether the differences of one line of Bézier points agree at every seam.
static int smooth(const fmpq* b, int n, long step) {
  fmpq_t left, right;
  fmpq_init(left);
  fmpq_init(right);
  int equal = 1;
  for (long k = 1; k < n - 3 && equal; ++k) {
    const fmpq* m = b + 3 * k * step;
    fmpq_sub(left, m, m - step);
    fmpq_sub(right, m + step, m);
    equal = fmpq_equal(left, right);
    fmpq_sub(left, left, m - step);
    fmpq_add(left, left, m - 2 * step);
    fmpq_sub(right, m + 2 * step, m + step);
    fmpq_sub(right, right, m + step);
    fmpq_add(right, right, m);
    equal = equal && fmpq_equal(left, right);
  }
  fmpq_clear(left);
  fmpq_clear(right);
  return equal;
}

static int w4(int n, int mutant) {
  const fmpq* net = given(n);
  const long m = 3L * (n - 3) + 1;
  fmpq* rows = new_numbers(m * n * 3);
  fmpq* all = new_numbers(m * m * 3);
  for (long c = 0; c < 3L * n; ++c) to_bezier(rows + c, net + c, n, 3L * n, 3L * n, mutant);
  for (long i = 0; i < m; ++i)
    for (long k = 0; k < 3; ++k) to_bezier(all + i * m * 3 + k, rows + i * n * 3 + k, n, 3, 3, 0);
  int equal = 1;
  for (long c = 0; c < 3 * m && equal; ++c) equal = smooth(all + c, n, 3 * m);
  for (long i = 0; i < m && equal; ++i)
    for (long k = 0; k < 3 && equal; ++k) equal = smooth(all + i * m * 3 + k, n, 3);
  free_numbers(rows, m * n * 3);
  free_numbers(all, m * m * 3);
  return equal;
}

int main(int argc, char** argv) {
  const struct Workload all[] = {{"W4", w4}, {NULL, NULL}};
  return measure_named(all, argc, argv);
}
