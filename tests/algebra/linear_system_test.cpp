#include <patchproof/algebra/linear_system.hpp>

#include <catch2/catch.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

namespace {

using Matrix = std::vector<std::vector<Rational>>;

// The rank of a matrix of numbers, by an elimination of its own.
std::size_t rank_of(Matrix rows) {
  std::size_t rank = 0;
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  for (std::size_t c = 0; c < columns; ++c) {
    std::size_t r = rank;
    while (r < rows.size() && rows[r][c] == 0) ++r;
    if (r == rows.size()) continue;
    std::swap(rows[rank], rows[r]);
    for (std::size_t other = rank + 1; other < rows.size(); ++other) {
      const Rational factor = rows[other][c] / rows[rank][c];
      for (std::size_t k = c; k < columns; ++k) rows[other][k] -= factor * rows[rank][k];
    }
    ++rank;
  }
  return rank;
}

struct System {
  Matrix matrix;
  std::vector<Rational> right;

  std::vector<LinearEquation> equations() const {
    std::vector<LinearEquation> result;
    for (std::size_t r = 0; r < matrix.size(); ++r) {
      LinearEquation equation;
      for (const Rational& c : matrix[r]) equation.coefficients.emplace_back(c);
      equation.right = right[r];
      result.push_back(std::move(equation));
    }
    return result;
  }
};

// Rows that depend on each other are likely: the rank is to vary.
System random_system(std::mt19937& random, std::size_t rows, std::size_t columns) {
  System result;
  for (std::size_t r = 0; r < rows; ++r) {
    std::vector<Rational> row;
    if (r > 0 && random() % 3 == 0) {
      const Rational factor = random_rational(random);
      for (const Rational& c : result.matrix[random() % r]) row.push_back(factor * c);
    } else {
      for (std::size_t c = 0; c < columns; ++c) row.push_back(random_small(random, 2));
    }
    result.matrix.push_back(row);
    result.right.push_back(random_small(random, 2));
  }
  return result;
}

// The unknowns when the free ones get the given values.
std::vector<Rational> unknowns(const LinearSolution& found, const std::vector<Rational>& free) {
  std::vector<Rational> result;
  for (std::size_t k = 0; k < found.constant_part.size(); ++k) {
    Rational total = found.constant_part[k].numerator().constant();
    for (std::size_t f = 0; f < found.free.size(); ++f)
      total += found.factors[k][f].numerator().constant() * free[f];
    result.push_back(total);
  }
  return result;
}

}  // namespace

TEST_CASE("solutions satisfy the equations for all values of the free unknowns", "[law]") {
  std::mt19937 random{40};
  int solvable = 0;
  for (int i = 0; i < 300; ++i) {
    const std::size_t columns = 1 + random() % 5;
    const System system = random_system(random, 1 + random() % 5, columns);
    Budget budget{Limits{}};
    const LinearSolution found = solution(system.equations(), columns, budget);
    Matrix extended = system.matrix;
    for (std::size_t r = 0; r < extended.size(); ++r) extended[r].push_back(system.right[r]);
    // Rouché and Capelli: solvable exactly when the right sides do not raise the rank.
    CHECK(found.contradictions.empty() == (rank_of(extended) == rank_of(system.matrix)));
    CHECK(found.pivots.empty());
    if (!found.contradictions.empty()) continue;
    ++solvable;
    CHECK(found.free.size() == columns - rank_of(system.matrix));
    std::vector<Rational> free;
    for (std::size_t f = 0; f < found.free.size(); ++f) free.push_back(random_rational(random));
    const std::vector<Rational> x = unknowns(found, free);
    for (std::size_t f = 0; f < found.free.size(); ++f) CHECK(x[found.free[f]] == free[f]);
    for (std::size_t r = 0; r < system.matrix.size(); ++r) {
      Rational left = 0;
      for (std::size_t c = 0; c < columns; ++c) left += system.matrix[r][c] * x[c];
      CHECK(left == system.right[r]);
    }
  }
  CHECK(solvable > 100);
  CHECK(solvable < 290);
}

TEST_CASE("systems with symbols are solved wherever their pivots do not vanish", "[law]") {
  std::mt19937 random{41};
  for (int i = 0; i < 60; ++i) {
    const std::size_t size = 1 + random() % 3;
    std::vector<LinearEquation> equations;
    for (std::size_t r = 0; r < size; ++r) {
      LinearEquation equation;
      for (std::size_t c = 0; c < size; ++c)
        equation.coefficients.emplace_back(random_polynomial(random, 2, 1, 2));
      equation.right = random_polynomial(random, 2, 1, 2);
      equations.push_back(equation);
    }
    Budget budget{Limits{}};
    const LinearSolution found = solution(equations, size, budget);
    if (!found.contradictions.empty() || !found.free.empty()) continue;
    for (const LinearEquation& equation : equations) {
      Fraction left;
      for (std::size_t c = 0; c < size; ++c)
        left = sum(left, product(equation.coefficients[c], found.constant_part[c], budget), budget);
      INFO(words(left) << " == " << words(equation.right));
      CHECK(difference(left, equation.right, budget).is_zero());
    }
    // At a point where no pivot vanishes the solution has a value.
    const Point at = random_point(random, 2);
    bool good = true;
    for (const Polynomial& pivot : found.pivots) good = good && value_at(pivot, at) != 0;
    if (!good) continue;
    for (const Fraction& x : found.constant_part) CHECK(denominator_at(x, at) != 0);
  }
}

TEST_CASE("a number is preferred to a symbol as a pivot, so that no condition arises") {
  Budget budget{Limits{}};
  const Fraction a{Polynomial::variable(0)};
  const LinearSolution found = solution(
      {{{a, Rational{1}}, Rational{0}}, {{Rational{1}, Rational{0}}, Rational{3}}}, 2, budget);
  CHECK(found.pivots.empty());
  CHECK(found.free.empty());
  CHECK(found.constant_part[0].numerator() == Polynomial{Rational{3}});
  CHECK(found.constant_part[1].numerator() == scaled(a.numerator(), -3));
}

TEST_CASE("dividing by a symbol leaves it among the pivots") {
  Budget budget{Limits{}};
  const Fraction a{Polynomial::variable(0)};
  const LinearSolution found = solution({{{a}, a}}, 1, budget);
  REQUIRE(found.pivots.size() == 1);
  CHECK(found.pivots.front() == a.numerator());
  CHECK(found.constant_part.front().numerator() == Polynomial{Rational{1}});
}

TEST_CASE("unknowns late in the order are left free") {
  Budget budget{Limits{}};
  const LinearSolution found =
      solution({{{Rational{1}, Rational{2}, Rational{0}}, Rational{4}}}, 3, budget);
  CHECK(found.free == std::vector<std::size_t>{1, 2});
  CHECK(found.constant_part[0].numerator() == Polynomial{Rational{4}});
  CHECK(found.factors[0][0].numerator() == Polynomial{Rational{-2}});
}

TEST_CASE("no equations leave everything free; 0 == 1 contradicts") {
  Budget budget{Limits{}};
  CHECK(solution({}, 2, budget).free.size() == 2);
  const LinearSolution impossible = solution({{{Rational{0}}, Rational{1}}}, 1, budget);
  CHECK(impossible.contradictions.size() == 1);
}

}  // namespace patchproof
