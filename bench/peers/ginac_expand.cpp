// W1, W2, W3 with GiNaC: the claim as an expression, difference expanded.
#include <ginac/ginac.h>

#include <functional>
#include <string>
#include <vector>

#include "measure.h"

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::pow;
using GiNaC::symbol;

namespace {

const symbol u{"u"}, v{"v"}, a{"a"}, b{"b"}, c{"c"}, d{"d"};

/// The boundary points of a net of n + 1 rows and columns.
struct Net {
  explicit Net(int size) : n{size} {
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        points.push_back(i % n == 0 || j % n == 0 ? ex{symbol{}} : ex{0});
  }
  const ex& at(int i, int j) const { return points[static_cast<std::size_t>(i * (n + 1) + j)]; }
  int n;
  std::vector<ex> points;
};

/// The net is made once for each size: naming symbols is no part of the proof.
const Net& net_of(int n) {
  static const Net net{n};
  return net;
}

ex bernstein(int n, int i, const ex& t) {
  return GiNaC::binomial(numeric{n}, numeric{i}) * pow(t, i) * pow(1 - t, n - i);
}

ex curve(int n, const ex& t, const std::function<ex(int)>& point) {
  GiNaC::exvector terms;
  for (int k = 0; k <= n; ++k) terms.push_back(bernstein(n, k, t) * point(k));
  return GiNaC::add{terms};
}

using Function = std::function<ex(const ex&, const ex&)>;

/// The Coons patch of the edges of a function.
ex coons_of(const Function& r, const ex& s, const ex& t) {
  return (1 - t) * r(s, 0) + t * r(s, 1) + (1 - s) * r(0, t) + s * r(1, t) -
         (1 - s) * (1 - t) * r(0, 0) - s * (1 - t) * r(1, 0) - (1 - s) * t * r(0, 1) -
         s * t * r(1, 1);
}

/// The Coons patch of the boundary points.
ex coons(const Net& net, const ex& s, const ex& t) {
  const int n = net.n;
  return (1 - t) * curve(n, s, [&](int i) { return net.at(i, 0); }) +
         t * curve(n, s, [&](int i) { return net.at(i, n); }) +
         (1 - s) * curve(n, t, [&](int j) { return net.at(0, j); }) +
         s * curve(n, t, [&](int j) { return net.at(n, j); }) - (1 - s) * (1 - t) * net.at(0, 0) -
         s * (1 - t) * net.at(n, 0) - (1 - s) * t * net.at(0, n) - s * t * net.at(n, n);
}

/// A point of the discrete Coons net; one factor of the mutant is wrong.
ex net_point(const Net& net, int i, int j, int mutant) {
  const int n = net.n;
  const numeric s{i, n}, t{j, n};
  ex sum = (1 - t) * net.at(i, 0) + t * net.at(i, n) + (1 - s) * net.at(0, j) + s * net.at(n, j) -
           (1 - s) * (1 - t) * net.at(0, 0) - s * (1 - t) * net.at(n, 0) -
           (1 - s) * t * net.at(0, n) - s * t * net.at(n, n);
  if (i == 1 && j == 1) sum += numeric{mutant, n * n} * net.at(0, 1);
  return sum;
}

int w1(int n, int mutant) {
  const Net& net = net_of(n);
  // Expanded row by row, which is several times faster than all at once.
  GiNaC::exvector at_v;
  for (int j = 0; j <= n; ++j) at_v.push_back(bernstein(n, j, v).expand());
  GiNaC::exvector rows;
  for (int i = 0; i <= n; ++i) {
    GiNaC::exvector row;
    for (int j = 0; j <= n; ++j)
      row.push_back(at_v[static_cast<std::size_t>(j)] * net_point(net, i, j, mutant));
    rows.push_back(bernstein(n, i, u).expand() * ex{GiNaC::add{row}}.expand());
  }
  const ex difference = coons(net, u, v) - ex{GiNaC::add{rows}};
  return difference.expand().is_zero();
}

/// The mutant has u^2 v^2 times one of the points too many.
int w2(int n, int mutant) {
  const Net& net = net_of(n);
  const ex patch = coons(net, u, v) + mutant * pow(u, 2) * pow(v, 2) * net.at(0, 1);
  // Expanded first: differentiating the products takes longer.
  return patch.expand().diff(u, 2).diff(v, 2).expand().is_zero();
}

/// The mutant takes one corner from the wrong place.
int w3(int n, int mutant) {
  const Net& net = net_of(n);
  const Function part = [&](const ex& s, const ex& t) {
    return coons(net, a + s * (b - a), c + t * (d - c));
  };
  const Function edges = [&](const ex& s, const ex& t) {
    const bool wrong = mutant != 0 && s.is_equal(1) && t.is_equal(1);
    return part(wrong ? ex{0} : s, t);
  };
  return ex{coons_of(edges, u, v) - part(u, v)}.expand().is_zero();
}

}  // namespace

int main(int argc, char** argv) {
  const Workload all[] = {{"W1", w1}, {"W2", w2}, {"W3", w3}, {nullptr, nullptr}};
  return measure_named(all, argc, argv);
}
