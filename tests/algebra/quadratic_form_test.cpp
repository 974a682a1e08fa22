#include <catch2/catch.hpp>
#include <random>

#include <patchproof/algebra/quadratic_form.hpp>

namespace patchproof {

namespace {

using Matrix = std::vector<std::vector<Rational>>;
using Kind = QuadraticForm::Kind;

Rational value_at(const Matrix& matrix, const std::vector<Rational>& x) {
  Rational total = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) total += x[i] * matrix[i][j] * x[j];
  return total;
}

// Sum of signs[k] times the square of a random linear form.
Matrix random_form(std::mt19937& random, std::size_t n, const std::vector<int>& signs) {
  std::uniform_int_distribution<int> entry{-3, 3};
  Matrix result(n, std::vector<Rational>(n));
  for (const int sign : signs) {
    std::vector<int> form;
    for (std::size_t i = 0; i < n; ++i) form.push_back(entry(random));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) result[i][j] += sign * form[i] * form[j];
  }
  return result;
}

}  // namespace

TEST_CASE("sums of squares are never negative", "[quadratic_form][law]") {
  std::mt19937 random{5};
  Budget budget{Limits{}};
  for (int round = 0; round < 40; ++round) {
    const QuadraticForm few = quadratic_form(random_form(random, 5, {1, 2, 1}), budget);
    CHECK(few.kind == Kind::positive_semidefinite);
    CHECK(few.pivots.size() <= 3);
    CHECK(quadratic_form(random_form(random, 4, {1, 1, 2, 3, 1, 1, 4, 1, 1}), budget).kind !=
          Kind::somewhere_negative);
  }
}

TEST_CASE("where a form is said to be negative it is", "[quadratic_form][law]") {
  std::mt19937 random{6};
  Budget budget{Limits{}};
  int negative = 0;
  for (int round = 0; round < 60; ++round) {
    const Matrix matrix = random_form(random, 4, {1, -1, 2, -1});
    const QuadraticForm form = quadratic_form(matrix, budget);
    if (form.kind != Kind::somewhere_negative) continue;
    ++negative;
    CHECK(value_at(matrix, form.negative_at) < 0);
  }
  CHECK(negative > 40);
}

TEST_CASE("small forms", "[quadratic_form][literature]") {
  Budget budget{Limits{}};
  CHECK(quadratic_form({}, budget).kind == Kind::positive_definite);
  const QuadraticForm hilbert =
      quadratic_form({{1, Rational{1, 2}}, {Rational{1, 2}, Rational{1, 3}}}, budget);
  CHECK(hilbert.kind == Kind::positive_definite);
  CHECK(hilbert.pivots == std::vector<Rational>{1, Rational{1, 12}});
  CHECK(quadratic_form({{0}}, budget).kind == Kind::positive_semidefinite);
  const Matrix mixed{{0, 1}, {1, 0}};
  CHECK(value_at(mixed, quadratic_form(mixed, budget).negative_at) < 0);
}

}  // namespace patchproof
