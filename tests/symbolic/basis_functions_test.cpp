#include <patchproof/symbolic/basis_functions.hpp>

#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include <tests/symbolic/terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

Rational choose(int n, int k) {
  Rational result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

std::vector<Rational> knots(const std::vector<long>& values) {
  return {values.begin(), values.end()};
}

// All basis functions of one degree on one span, added.
Term sum_on_span(int degree, int span, const std::vector<Rational>& knots, const Term& t) {
  Term sum = number(0);
  for (int i = 0; i + degree + 1 < static_cast<int>(knots.size()); ++i) {
    sum = sum + basis({degree, i, span, knots}, t);
  }
  return sum;
}

}  // namespace

TEST_CASE("Bernstein polynomials of degrees up to 8 add to one", "[law]") {
  Declarations declare;
  const Term t = declare.parameter("t");
  for (int n = 0; n <= 8; ++n) {
    Term sum = number(0);
    Term most = number(0);
    for (int i = 0; i <= n; ++i) sum = sum + bernstein(n, i, t);
    for (int i = 0; i < n; ++i) most = most + bernstein(n, i, t);
    CAPTURE(n);
    CHECK(holds(sum, number(1)));
    CHECK(fails(most, number(1)));
  }
}

TEST_CASE("Bernstein polynomials are binomials times powers", "[law]") {
  Declarations declare;
  const Term t = declare.parameter("t");
  const Term a = declare.scalar("a");
  for (int n = 0; n <= 6; ++n) {
    for (int i = 0; i <= n; ++i) {
      CAPTURE(n, i);
      const Term argument = t - 2 * a;
      const Term formula =
          number_term(choose(n, i)) * (power(argument, i) * power(1 - argument, n - i));
      CHECK(holds(bernstein(n, i, argument), formula));
    }
  }
  CHECK(holds(bernstein(3, 4, t), number(0)));
  CHECK(reason(bernstein(100000, 4, t), t) ==
        "over budget: a Bernstein polynomial of too high a degree");
}

TEST_CASE("B-splines add to one on each inner span, for uniform, clamped and repeated knots",
          "[law]") {
  Declarations declare;
  const Term t = declare.parameter("t");
  struct Spline {
    int degree;
    std::vector<Rational> knots;
  };
  const std::vector<Spline> splines{
      {0, knots({0, 1, 2})},
      {1, knots({0, 0, 1, 3, 3})},
      {2, knots({0, 0, 0, 1, 1, 2, 2, 2})},
      {3, knots({0, 0, 0, 0, 1, 2, 2, 2, 2})},
      {3, knots({0, 1, 2, 3, 4, 5, 6, 7})},
      {3, {-1, Rational{-1, 2}, 0, Rational{1, 3}, 1, 4, 5, Rational{11, 2}}},
      {4, knots({0, 0, 0, 0, 0, 2, 2, 2, 3, 3, 3, 3, 3})},
  };
  for (const Spline& spline : splines) {
    const int last = static_cast<int>(spline.knots.size()) - spline.degree - 1;
    for (int span = spline.degree; span < last; ++span) {
      const auto s = static_cast<std::size_t>(span);
      if (spline.knots[s] == spline.knots[s + 1]) continue;
      CAPTURE(spline.degree, span);
      CHECK(holds(sum_on_span(spline.degree, span, spline.knots, t), number(1)));
    }
  }
  CHECK(fails(sum_on_span(3, 2, knots({0, 1, 2, 3, 4, 5, 6, 7}), t), number(1)));
}

TEST_CASE("B-splines satisfy the recursion of Cox and de Boor", "[law]") {
  std::mt19937 random{7};
  Declarations declare;
  const Term t = declare.parameter("t");
  for (int round = 0; round < 40; ++round) {
    const int degree = 1 + static_cast<int>(random() % 4);
    std::vector<Rational> k{0};
    while (static_cast<int>(k.size()) < 2 * degree + 4) k.push_back(k.back() + random() % 3);
    const int span = static_cast<int>(random() % (k.size() - 1));
    const auto s = static_cast<std::size_t>(span);
    if (k[s] == k[s + 1]) continue;
    const int i = static_cast<int>(random() % (k.size() - static_cast<std::size_t>(degree) - 1));
    const auto first = static_cast<std::size_t>(i);
    const auto end = first + static_cast<std::size_t>(degree) + 1;
    const Term x = number_term(k[s]) * (1 - t) + number_term(k[s + 1]) * t;
    Term expected = number(0);
    if (k[end - 1] != k[first]) {
      expected = expected + (x - number_term(k[first])) / number_term(k[end - 1] - k[first]) *
                                basis({degree - 1, i, span, k}, t);
    }
    if (k[end] != k[first + 1]) {
      expected = expected + (number_term(k[end]) - x) / number_term(k[end] - k[first + 1]) *
                                basis({degree - 1, i + 1, span, k}, t);
    }
    CAPTURE(round, degree, i, span);
    CHECK(holds(basis({degree, i, span, k}, t), expected));
  }
}

TEST_CASE("the uniform cubic B-spline has the matrix with 1/6 (1, 4, 1, 0)", "[literature]") {
  // Piegl & Tiller, The NURBS Book, 2.2; the last of four pieces is t^3/6.
  Declarations declare;
  const Term t = declare.parameter("t");
  const std::vector<Rational> k = knots({0, 1, 2, 3, 4, 5, 6, 7});
  CHECK(holds(basis({3, 3, 3, k}, t), power(t, 3) / 6));
  CHECK(holds(basis({3, 0, 3, k}, t), power(1 - t, 3) / 6));
  CHECK(holds(basis({3, 1, 3, k}, t), (4 - 6 * power(t, 2) + 3 * power(t, 3)) / 6));
  CHECK(fails(basis({3, 1, 3, k}, t), (4 + 6 * power(t, 2) + 3 * power(t, 3)) / 6));
}

TEST_CASE("basis functions that do not exist have no opinion", "[reject]") {
  Declarations declare;
  const Term t = declare.parameter("t");
  CHECK(reason(basis({1, 0, 0, knots({0, 0, 1, 1})}, t), t) == "an empty knot span");
  CHECK(reason(basis({1, 0, 0, knots({0, 1, 0, 1})}, t), t) == "the knots of a B-spline decrease");
  CHECK(reason(basis({3, 1, 0, knots({0, 1, 2, 3})}, t), t) ==
        "a B-spline basis function that does not exist");
}
