// W4 with the rational numbers of CLN, which are GiNaC's: as flint_net.c does it.
#include <cln/cln.h>

#include <vector>

#include "measure.h"

using cln::cl_I;
using cln::cl_RA;
using Numbers = std::vector<cl_RA>;

namespace {

/// The net is given, so it is no part of the proof.
const Numbers& given(long n) {
  static Numbers net;
  if (net.empty())
    for (long i = 0; i < n; ++i)
      for (long j = 0; j < n; ++j)
        for (long k = 0; k < 3; ++k)
          net.push_back(cl_I{(7 * i + 13 * j + 5 * k + i * j) % 101 - 50} /
                        cl_I{1 + (i + 2 * j + 3 * k) % 7});
  return net;
}

long knot(long k, long last) { return k < 0 ? 0 : k > last ? last : k; }

void to_bezier(cl_RA* b, const cl_RA* d, long n, long to_step, long from_step, bool mutant) {
  const long last = n - 3;
  b[0] = d[0];
  b[3 * last * to_step] = d[(n - 1) * from_step];
  for (long k = 0; k < last; ++k) {
    const cl_RA& p = d[(k + 1) * from_step];
    const cl_RA change = d[(k + 2) * from_step] - p;
    const long begin = knot(k - 1, last);
    const cl_I length = knot(k + 2, last) - begin;
    for (long side = 1; side < 3; ++side) {
      cl_RA factor = cl_I{knot(k + side - 1, last) - begin} / length;
      if (mutant && k == 1 && side == 1) factor = cl_I{1} / cl_I{5};
      b[(3 * k + side) * to_step] = p + factor * change;
    }
  }
  const cl_RA half = cl_I{1} / cl_I{2};
  for (long k = 1; k < last; ++k)
    b[3 * k * to_step] = (b[(3 * k - 1) * to_step] + b[(3 * k + 1) * to_step]) * half;
}

bool smooth(const cl_RA* b, long n, long step) {
  for (long k = 1; k < n - 3; ++k) {
    const cl_RA* m = b + 3 * k * step;
    const cl_RA left = m[0] - m[-step], right = m[step] - m[0];
    if (left != right) return false;
    if (left - m[-step] + m[-2 * step] != m[2 * step] - m[step] - right) return false;
  }
  return true;
}

int w4(int size, int mutant) {
  const long n = size, m = 3 * (n - 3) + 1;
  const Numbers& net = given(n);
  Numbers rows(static_cast<std::size_t>(m * n * 3)), all(static_cast<std::size_t>(m * m * 3));
  for (long c = 0; c < 3 * n; ++c)
    to_bezier(rows.data() + c, net.data() + c, n, 3 * n, 3 * n, mutant != 0);
  for (long i = 0; i < m; ++i)
    for (long k = 0; k < 3; ++k)
      to_bezier(all.data() + i * m * 3 + k, rows.data() + i * n * 3 + k, n, 3, 3, false);
  for (long c = 0; c < 3 * m; ++c)
    if (!smooth(all.data() + c, n, 3 * m)) return 0;
  for (long i = 0; i < m; ++i)
    for (long k = 0; k < 3; ++k)
      if (!smooth(all.data() + i * m * 3 + k, n, 3)) return 0;
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const Workload all[] = {{"W4", w4}, {nullptr, nullptr}};
  return measure_named(all, argc, argv);
}
