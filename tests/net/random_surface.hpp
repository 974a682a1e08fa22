#pragma once

#include <map>
#include <random>
#include <tuple>
#include <vector>

#include <patchproof/net/segments.hpp>

namespace patchproof {

/// A net with its knots.
struct Surface {
  PointNet net;
  KnotVector u;
  KnotVector v;
};

/// Knots that do not decrease, of any multiplicity up to the degree inside, clamped or not.
inline KnotVector random_knots(std::mt19937_64& random, int degree, std::size_t points) {
  for (;;) {
    std::vector<Rational> knots;
    Rational knot{static_cast<int>(random() % 5) - 2};
    for (std::size_t k = 0; k < points + static_cast<std::size_t>(degree) + 1; ++k) {
      if (random() % 3 != 0)
        knot += Rational{static_cast<int>(1 + random() % 3), static_cast<int>(1 + random() % 2)};
      knots.push_back(knot);
    }
    try {
      return {degree, knots, points};
    } catch (const KnotFault&) {
      // Too many equal ones.
    }
  }
}

/// A small surface whose numerators stay below `largest`.
inline Surface random_surface(std::mt19937_64& random, std::int64_t largest = 20) {
  const int p = 1 + static_cast<int>(random() % 4);
  const int q = 1 + static_cast<int>(random() % 4);
  PointNet net;
  net.rows = static_cast<std::size_t>(p) + 1 + random() % 4;
  net.columns = static_cast<std::size_t>(q) + 1 + random() % 4;
  net.dimension = 1 + random() % 3;
  const auto span = static_cast<std::uint64_t>(2 * largest + 1);
  for (std::size_t k = 0; k < net.rows * net.columns * net.dimension; ++k)
    net.coordinates.emplace_back(static_cast<std::int64_t>(random() % span) - largest,
                                 static_cast<std::int64_t>(1 + random() % 4));
  const std::size_t rows = net.rows;
  const std::size_t columns = net.columns;
  return {std::move(net), random_knots(random, p, rows), random_knots(random, q, columns)};
}

/// The segments by (s, t, k, l, c).
using SegmentPoints =
    std::map<std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, std::size_t>, Rational>;

inline SegmentPoints segment_points(const Surface& surface, int continuity = 1,
                                    std::optional<Arithmetic> arithmetic = std::nullopt) {
  SegmentPoints points;
  const auto p = static_cast<std::size_t>(surface.u.degree());
  const auto q = static_cast<std::size_t>(surface.v.degree());
  segments_of(
      surface.net, surface.u, surface.v, continuity,
      [&](const SegmentStrip& strip) {
        for (std::size_t t = 0; t < surface.v.spans(); ++t)
          for (std::size_t k = 0; k <= p; ++k)
            for (std::size_t l = 0; l <= q; ++l)
              for (std::size_t c = 0; c < surface.net.dimension; ++c)
                points[{strip.number(), t, k, l, c}] = strip.coordinate(t, k, l, c);
      },
      arithmetic);
  return points;
}

/// N[i] of degree p at x by the recursion of Cox and de Boor, 0/0 = 0. Source: Piegl and Tiller,
/// The NURBS Book, (2.5).
inline Rational basis_function(const std::vector<Rational>& t, std::size_t i, std::size_t p,
                               const Rational& x) {
  if (p == 0) return t[i] <= x && x < t[i + 1] ? 1 : 0;
  Rational sum;
  if (t[i + p] != t[i]) sum += (x - t[i]) / (t[i + p] - t[i]) * basis_function(t, i, p - 1, x);
  if (t[i + p + 1] != t[i + 1])
    sum += (t[i + p + 1] - x) / (t[i + p + 1] - t[i + 1]) * basis_function(t, i + 1, p - 1, x);
  return sum;
}

}  // namespace patchproof
