#include <patchproof/net/segments.hpp>

#include <catch2/catch.hpp>

#include <patchproof/algebra/number.hpp>
#include <tests/net/random_surface.hpp>

using namespace patchproof;

namespace {

/// One coordinate of the spline by its basis functions.
Rational spline_value(const Surface& surface, const Rational& x, const Rational& y, std::size_t c) {
  Rational sum;
  for (std::size_t i = 0; i < surface.net.rows; ++i) {
    const Rational weight =
        basis_function(surface.u.knots(), i, static_cast<std::size_t>(surface.u.degree()), x);
    if (weight.sign() == 0) continue;
    for (std::size_t j = 0; j < surface.net.columns; ++j)
      sum += weight *
             basis_function(surface.v.knots(), j, static_cast<std::size_t>(surface.v.degree()), y) *
             surface.net.coordinate(i, j, c);
  }
  return sum;
}

Rational bernstein(std::size_t n, std::size_t i, const Rational& t) {
  Rational value{1};
  for (std::size_t k = 1; k <= i; ++k)
    value *= Rational{static_cast<int>(n - i + k), static_cast<int>(k)};
  return value * power(t, static_cast<long>(i)) * power(Rational{1} - t, static_cast<long>(n - i));
}

/// One coordinate of a segment at local parameters.
Rational segment_value(const SegmentPoints& points, const Surface& surface, std::size_t s,
                       std::size_t t, const Rational& x, const Rational& y, std::size_t c) {
  const auto p = static_cast<std::size_t>(surface.u.degree());
  const auto q = static_cast<std::size_t>(surface.v.degree());
  Rational sum;
  for (std::size_t k = 0; k <= p; ++k)
    for (std::size_t l = 0; l <= q; ++l)
      sum += bernstein(p, k, x) * bernstein(q, l, y) * points.at({s, t, k, l, c});
  return sum;
}

/// A row of numbers as a net of degree (degree, 1) that is constant in v.
Surface curve(int degree, std::vector<Rational> knots, const std::vector<Rational>& values) {
  PointNet net;
  net.rows = values.size();
  net.columns = 2;
  net.dimension = 1;
  for (const Rational& value : values)
    net.coordinates.insert(net.coordinates.end(), {value, value});
  return {std::move(net), KnotVector{degree, std::move(knots), values.size()},
          KnotVector::clamped_uniform(1, 2)};
}

}  // namespace

TEST_CASE("Segments are the spline at random parameters", "[net][law]") {
  std::mt19937_64 random{4};
  for (int k = 0; k < 60; ++k) {
    const Surface surface = random_surface(random);
    const SegmentPoints points = segment_points(surface);
    for (int place = 0; place < 4; ++place) {
      const std::size_t s = random() % surface.u.spans();
      const std::size_t t = random() % surface.v.spans();
      const Rational x{static_cast<int>(random() % 9), 9};
      const Rational y{static_cast<int>(random() % 7), 7};
      for (std::size_t c = 0; c < surface.net.dimension; ++c)
        CHECK(segment_value(points, surface, s, t, x, y, c) ==
              spline_value(surface, surface.u.begin_of(s) + x * surface.u.length_of(s),
                           surface.v.begin_of(t) + y * surface.v.length_of(t), c));
    }
  }
}

TEST_CASE("All arithmetics give the same", "[net][law]") {
  std::mt19937_64 random{5};
  for (int k = 0; k < 40; ++k) {
    const Surface surface = random_surface(random);
    const SegmentFindings found = segments_of(surface.net, surface.u, surface.v, 2);
    CHECK(found.are_the_surface);
    CHECK(found.for_every_net);
    const SegmentPoints points = segment_points(surface, 2, Arithmetic::fractions);
    for (const Arithmetic arithmetic : {Arithmetic::words, Arithmetic::double_words}) {
      if (arithmetic < found.arithmetic) continue;
      CHECK(segment_points(surface, 2, arithmetic) == points);
      const SegmentFindings other =
          segments_of(surface.net, surface.u, surface.v, 2, {}, arithmetic);
      CHECK(other.are_the_surface);
      CHECK(other.u.broken_edges == found.u.broken_edges);
      CHECK(other.v.broken_edges == found.v.broken_edges);
      CHECK(other.u.first_break.has_value() == found.u.first_break.has_value());
      if (!other.u.first_break) continue;
      CHECK(other.u.first_break->before == found.u.first_break->before);
      CHECK(other.u.first_break->behind == found.u.first_break->behind);
    }
  }
}

TEST_CASE("Words are left exactly where the bound leaves them", "[net][law]") {
  std::mt19937_64 random{6};
  for (const std::size_t limit : {std::size_t{64}, std::size_t{128}}) {
    const Arithmetic inside = limit == 64 ? Arithmetic::words : Arithmetic::double_words;
    for (int k = 0; k < 8; ++k) {
      Surface surface = random_surface(random);
      // Bits of the bound are those of the largest coordinate and a constant: make it that large.
      surface.net.coordinates[0] = power(Rational{2}, 40);
      const std::size_t at_40 = segments_of(surface.net, surface.u, surface.v, 2).bits;
      const long fits = static_cast<long>(40 + limit) - static_cast<long>(at_40);
      for (Rational& coordinate : surface.net.coordinates)
        coordinate = power(Rational{2}, fits) * Rational{random() % 2 == 0 ? 1 : -1};
      const SegmentFindings most = segments_of(surface.net, surface.u, surface.v, 2);
      // The common denominator may be smaller than it was.
      REQUIRE(most.bits <= limit);
      for (Rational& coordinate : surface.net.coordinates)
        coordinate *= power(Rational{2}, static_cast<long>(limit - most.bits));
      const SegmentFindings full = segments_of(surface.net, surface.u, surface.v, 2);
      CHECK(full.bits == limit);
      CHECK(full.arithmetic == inside);
      CHECK(full.are_the_surface);
      CHECK(segment_points(surface, 2, inside) ==
            segment_points(surface, 2, Arithmetic::fractions));
      for (Rational& coordinate : surface.net.coordinates) coordinate *= Rational{2};
      const SegmentFindings over = segments_of(surface.net, surface.u, surface.v, 2);
      CHECK(over.bits == limit + 1);
      CHECK(over.arithmetic > inside);
      CHECK_THROWS_AS(segments_of(surface.net, surface.u, surface.v, 2, {}, inside),
                      std::overflow_error);
    }
  }
}

TEST_CASE("Two insertions of a knot cut a clamped cubic", "[net][literature]") {
  // Farin, Curves and Surfaces for CAGD, section 8.7: end legs are halved, the inner one twice.
  const Surface surface = curve(3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, {0, 8, 16, 0, -8});
  const SegmentPoints points = segment_points(surface);
  const std::vector<std::vector<int>> expected{{0, 8, 12, 10}, {10, 8, 0, -8}};
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t k = 0; k <= 3; ++k)
      CHECK(points.at({s, 0, k, 0, 0}) == Rational{expected[s][k]});
}

TEST_CASE("The value of example 4.1 of The NURBS Book", "[net][literature]") {
  // Piegl and Tiller: degree 2, knots 0,0,0,1,2,3,3,3, weights 1,4,1,1,1; C(1) = (7/5, 6/5), of the
  // homogeneous points (w x, w y, w).
  Surface surface = curve(2, {0, 0, 0, 1, 2, 3, 3, 3}, {0, 0, 0, 0, 0});
  surface.net.dimension = 3;
  surface.net.coordinates.clear();
  for (const std::vector<int>& point :
       std::vector<std::vector<int>>{{0, 0, 1}, {4, 4, 4}, {3, 2, 1}, {4, 1, 1}, {5, -1, 1}})
    for (int twice = 0; twice < 2; ++twice)
      surface.net.coordinates.insert(surface.net.coordinates.end(), point.begin(), point.end());
  const SegmentPoints points = segment_points(surface);
  const Rational weight = points.at({1, 0, 0, 0, 2});
  CHECK(weight == Rational{5, 2});
  CHECK(points.at({1, 0, 0, 0, 0}) / weight == Rational{7, 5});
  CHECK(points.at({1, 0, 0, 0, 1}) / weight == Rational{6, 5});
}

TEST_CASE("At a knot that occurs m times only C^(p-m) is given", "[net]") {
  const std::vector<Rational> knots{0, 0, 0, 0, 1, 1, 2, 2, 2, 2};
  const Surface surface = curve(3, knots, {0, 1, 5, 2, 7, 1});
  const SegmentFindings found = segments_of(surface.net, surface.u, surface.v, 2);
  CHECK(found.are_the_surface);
  CHECK(found.u.given_order == 1);
  REQUIRE(found.u.first_break);
  CHECK(found.u.first_break->order == 2);
  CHECK(found.u.broken_edges == 1);
  CHECK_FALSE(segments_of(surface.net, surface.u, surface.v, 1).u.first_break);
  // Points on a line at the Greville abscissae are the line itself, which has all derivatives.
  const Surface line =
      curve(3, knots, {0, Rational{1, 3}, Rational{2, 3}, Rational{4, 3}, Rational{5, 3}, 2});
  CHECK_FALSE(segments_of(line.net, line.u, line.v, 3).u.first_break);
}

TEST_CASE("Derivatives at a break are those of the spline", "[net]") {
  // Over the knots 0, 1, 3 the polygon 0, 2, 8 of degree 1 has the slopes 2 and 3.
  const Surface surface = curve(1, {0, 0, 1, 3, 3}, {0, 2, 8});
  const SegmentFindings found = segments_of(surface.net, surface.u, surface.v, 1);
  REQUIRE(found.u.first_break);
  CHECK(found.u.first_break->before == Rational{2});
  CHECK(found.u.first_break->behind == Rational{3});
}

TEST_CASE("A knot of full multiplicity cuts the surface", "[net]") {
  const Surface surface = curve(1, {0, 0, 1, 1, 2, 2}, {0, 1, 5, 6});
  const SegmentFindings found = segments_of(surface.net, surface.u, surface.v, 0);
  CHECK(found.are_the_surface);
  CHECK(found.u.given_order == -1);
  REQUIRE(found.u.first_break);
  CHECK(found.u.first_break->order == 0);
  CHECK(found.u.first_break->before == Rational{1});
  CHECK(found.u.first_break->behind == Rational{5});
}

TEST_CASE("Denominators without anything in common need fractions", "[net]") {
  Surface surface = curve(3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, {0, 8, 16, 0, -8});
  int odd = 2'000'000'001;
  for (Rational& coordinate : surface.net.coordinates) coordinate /= Rational{odd += 2};
  const SegmentFindings found = segments_of(surface.net, surface.u, surface.v, 2);
  CHECK(found.arithmetic == Arithmetic::fractions);
  CHECK(found.are_the_surface);
  CHECK(found.from_numbers);
  CHECK_FALSE(found.u.first_break);
}

TEST_CASE("Points that no span needs are counted", "[net]") {
  const Surface surface = curve(2, {0, 0, 0, 2, 2, 2, 3}, {1, 2, 3, 4});
  CHECK(segments_of(surface.net, surface.u, surface.v, 1).unused_points == 2);
}

TEST_CASE("Knots that do not fit are refused", "[net][reject]") {
  const auto fault = [](int degree, std::vector<Rational> knots, std::size_t points) {
    try {
      KnotVector{degree, std::move(knots), points};
      return std::string{};
    } catch (const KnotFault& problem) {
      return std::string{problem.what()};
    }
  };
  CHECK(fault(1, {0, 0, 1, 1}, 2).empty());
  CHECK(fault(0, {0, 1}, 1) == "the degree has to lie between 1 and 9");
  CHECK(fault(10, {}, 30) == "the degree has to lie between 1 and 9");
  CHECK(fault(3, {}, 3) == "degree 3 needs at least 4 points, and there are 3");
  CHECK(fault(1, {0, 0, 1}, 2) == "2 points of degree 1 need 4 knots, not 3");
  CHECK(fault(1, {0, 0, 1, Rational{1, 2}}, 2) == "the knots decrease from 1 to 1/2");
  CHECK(fault(1, {0, 0, 0, 1}, 2) == "the knot 0 occurs more than 2 times");
  CHECK(fault(1, {0, 1, 1, 2}, 2) ==
        "these knots leave no interval for the spline to be defined on");
  const Surface surface = curve(1, {0, 0, 1, 1}, {0, 1});
  CHECK_THROWS_WITH(segments_of(surface.net, KnotVector::clamped_uniform(1, 3), surface.v, 0),
                    "the knots in u are for 3 points, not 2");
}
