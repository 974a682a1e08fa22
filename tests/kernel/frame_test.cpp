#include <patchproof/kernel/frame.hpp>

#include <catch2/catch.hpp>

namespace patchproof {
namespace {

constexpr Variable u = 0;
constexpr Variable v = 1;

Polynomial power_of(Variable variable, unsigned exponent) {
  return Polynomial::from_terms({{Monomial{variable, exponent}, 1}});
}

// The derivative of the base in u, of an order, where u has a value.
Polynomial across(const Frame& frame, int order, const Rational& at, Budget& budget) {
  Polynomial p = frame.base;
  for (int k = 0; k < order; ++k) p = derivative(p, u);
  return substituted(p, {{u, Polynomial{at}}}, budget);
}

}  // namespace

TEST_CASE("a frame has the derivatives it was given, of every order, at both edges") {
  Budget budget{Limits{}};
  Frame frame{{}, Polynomial{1}};
  std::vector<EdgePolynomial> edges;
  for (int order = 0; order < 4; ++order)
    for (const Rational& at : {Rational{0}, Rational{2}})
      edges.push_back({u, at, order,
                       sum(power_of(v, static_cast<unsigned>(order) + 1),
                           Polynomial{Rational{at + 5 * order + 1}}, budget)});
  for (std::size_t added = 0; added < edges.size(); ++added) {
    add_edge(edges[added], frame, budget);
    for (std::size_t k = 0; k <= added; ++k) {
      INFO("order " << edges[k].order << " at " << to_text(edges[k].at));
      CHECK(across(frame, edges[k].order, edges[k].at, budget) == edges[k].value);
    }
  }
}

TEST_CASE("what vanishes on a frame changes none of its values") {
  Budget budget{Limits{}};
  Frame frame{{}, Polynomial{1}};
  add_edge({u, 0, 1, power_of(v, 2)}, frame, budget);
  add_edge({u, 1, 0, power_of(v, 3)}, frame, budget);
  const Frame other{sum(frame.base, product(frame.vanishing, power_of(u, 3), budget), budget),
                    frame.vanishing};
  CHECK(!(other.base == frame.base));
  CHECK(across(other, 0, 0, budget) == across(frame, 0, 0, budget));
  CHECK(across(other, 1, 0, budget) == power_of(v, 2));
  CHECK(across(other, 0, 1, budget) == power_of(v, 3));
}

}  // namespace patchproof
