#include <patchproof/kernel/interpolation.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

namespace {

Rational prescribed_value(const Polynomial& p, const Prescription& wanted) {
  Polynomial result = p;
  Point at;
  for (std::size_t k = 0; k < wanted.orders.size(); ++k) {
    for (int order = 0; order < wanted.orders[k]; ++order)
      result = derivative(result, static_cast<Variable>(k));
    at[static_cast<Variable>(k)] = wanted.at[k];
  }
  return value_at(result, at);
}

std::vector<Variable> first_variables(std::size_t count) {
  std::vector<Variable> result;
  for (std::size_t k = 0; k < count; ++k) result.push_back(static_cast<Variable>(k));
  return result;
}

Prescription random_place(std::mt19937& random, std::size_t variables) {
  Prescription result;
  for (std::size_t k = 0; k < variables; ++k) {
    result.orders.push_back(static_cast<int>(random() % 3));
    result.at.push_back(Rational(static_cast<int>(random() % 3), 2));
  }
  return result;
}

unsigned total_degree(const Polynomial& p) {
  unsigned result = 0;
  for (const auto& term : p.terms()) result = std::max(result, term.monomial.total_degree());
  return result;
}

}  // namespace

TEST_CASE("an interpolant has the prescribed values and derivatives", "[law]") {
  std::mt19937 random{60};
  for (int i = 0; i < 60; ++i) {
    const std::size_t variables = 1 + random() % 2;
    const Polynomial origin = random_polynomial(random, static_cast<unsigned>(variables), 3, 4);
    std::vector<Prescription> wanted;
    for (unsigned k = 0; k < 1 + random() % 4; ++k) {
      wanted.push_back(random_place(random, variables));
      wanted.back().value = prescribed_value(origin, wanted.back());
    }
    Budget budget{Limits{}};
    const auto found = interpolant(wanted, first_variables(variables), budget);
    REQUIRE(found);
    for (const Prescription& p : wanted) CHECK(prescribed_value(*found, p) == p.value);
    // Prescriptions of a polynomial are met by one of no higher degree.
    CHECK(total_degree(*found) <= total_degree(origin));
  }
}

TEST_CASE("any different places can be given any values", "[law]") {
  std::mt19937 random{61};
  for (int i = 0; i < 60; ++i) {
    std::vector<Prescription> wanted;
    for (int place = 0; place < 2; ++place)
      for (int order = 0; order < 2; ++order)
        wanted.push_back({{order}, {Rational{place}}, random_rational(random)});
    Budget budget{Limits{}};
    const auto found = interpolant(wanted, {0}, budget);
    REQUIRE(found);
    CHECK(found->degree(0) <= 3);  // Hermite interpolation with cubics
    for (const Prescription& p : wanted) CHECK(prescribed_value(*found, p) == p.value);
  }
}

TEST_CASE("two values at one place contradict each other", "[reject]") {
  Budget budget{Limits{}};
  CHECK_FALSE(interpolant({{{0}, {1}, 1}, {{0}, {1}, 2}}, {0}, budget));
  CHECK_FALSE(interpolant({{{0, 1}, {1, 0}, 0}, {{0, 1}, {1, 0}, 2}}, {0, 1}, budget));
  CHECK(interpolant({{{0}, {1}, 2}, {{0}, {1}, 2}}, {0}, budget) == Polynomial{Rational{2}});
}

TEST_CASE("nothing prescribed, or only zeros, is met by zero") {
  Budget budget{Limits{}};
  CHECK(interpolant({}, {0}, budget) == Polynomial{});
  CHECK(interpolant({{{1}, {1}, 0}}, {0}, budget) == Polynomial{});
}

}  // namespace patchproof
