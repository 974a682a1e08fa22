#include <patchproof/net/every_net.hpp>

#include <catch2/catch.hpp>

#include <patchproof/net/strip_conversion.hpp>
#include <tests/net/random_surface.hpp>

using namespace patchproof;

namespace {

/// Whether the segments over such plans are found to be the surface, from the numbers of its net.
bool found_right(const Surface& surface, const DirectionPlan& u_plan, const DirectionPlan& v_plan) {
  const StripWeights<Rational> u{u_plan};
  const StripWeights<Rational> v{v_plan};
  StripConversion<Rational> strips{surface.net.coordinates.data(), surface.net.columns,
                                   surface.net.dimension, u, v};
  bool right = true;
  for (std::size_t s = 0; s < u.spans(); ++s) {
    strips.convert(s);
    if (s > 0)
      strips.compare_with_last(s, [&](const Difference<Rational>& found) {
        right = right && found.order > u.seams[found.u_span].given_order;
      });
    strips.compare_inside(s, [&](const Difference<Rational>& found) {
      right = right && found.order > v.seams[found.v_span].given_order;
    });
    right = strips.leads_back(s) && right;
  }
  return right;
}

}  // namespace

TEST_CASE("The weights are right for every net", "[net][law]") {
  std::mt19937_64 random{9};
  for (int k = 0; k < 60; ++k) {
    const Surface surface = random_surface(random);
    CHECK(holds_for_every_net(direction_plan(surface.u, 2)));
    CHECK(holds_for_every_net(*whole_direction_plan(surface.v, 2)));
    CHECK(found_right(surface, direction_plan(surface.u, 2), direction_plan(surface.v, 2)));
  }
}

TEST_CASE("A single wrong weight is found, for every net and from the numbers", "[net][law]") {
  std::mt19937_64 random{10};
  for (int k = 0; k < 200; ++k) {
    const Surface surface = random_surface(random, 1'000'000);
    DirectionPlan u = direction_plan(surface.u, 2);
    DirectionPlan v = direction_plan(surface.v, 2);
    DirectionPlan& changed = k % 2 == 0 ? u : v;
    SpanPlan& span = changed.spans[random() % changed.spans.size()];
    span.weights[random() % span.weights.size()] +=
        Rational{1, 1 + static_cast<int>(random() % 99)};
    CHECK_FALSE(holds_for_every_net(changed));
    CHECK_FALSE(found_right(surface, u, v));
  }
}

TEST_CASE("A wrong way back is found", "[net]") {
  std::mt19937_64 random{11};
  for (int k = 0; k < 50; ++k) {
    const Surface surface = random_surface(random, 1'000'000);
    DirectionPlan u = direction_plan(surface.u, 2);
    ReturnPlan& back = u.spans[0].back.at(0);
    back.weights[random() % back.weights.size()] += Rational{1, 3};
    CHECK_FALSE(holds_for_every_net(u));
    CHECK_FALSE(found_right(surface, u, direction_plan(surface.v, 2)));
  }
}

TEST_CASE("Wrong seams of plans are found", "[net]") {
  const KnotVector knots{2, {0, 0, 0, 1, 3, 3, 3}, 4};
  DirectionPlan plan = direction_plan(knots, 1);
  CHECK(holds_for_every_net(plan));
  plan.seams[0].before[1] *= Rational{2};
  CHECK_FALSE(holds_for_every_net(plan));
}

TEST_CASE("The bound counts what a comparison multiplies by", "[net]") {
  // Degree 1 over 0, 1, 1001: derivatives of order 1 are compared as 1000 times a difference of two
  // numbers up to 1, 2000, with its sign 12 bits. Of order 0 the numbers themselves, 2 bits.
  PointNet net;
  net.rows = 3;
  net.columns = 2;
  net.dimension = 1;
  net.coordinates = {1, 1, -1, -1, 1, 1};
  const KnotVector u{1, {0, 0, 1, 1001, 1001}, 3};
  const KnotVector v = KnotVector::clamped_uniform(1, 2);
  CHECK(segments_of(net, u, v, 1).bits == 12);
  CHECK(segments_of(net, u, v, 0).bits == 2);
}
