#include <patchproof/kernel/matrix.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "algebra/random_algebra.hpp"

namespace patchproof {

namespace {

bool same(const Fraction& a, const Fraction& b) { return !(a < b) && !(b < a); }
bool same(const Components& a, const Components& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Fraction& x, const Fraction& y) { return same(x, y); });
}

Components random_components(std::mt19937& random, int count) {
  Components result;
  for (int k = 0; k < count; ++k) result.emplace_back(random_polynomial(random, 2, 1, 2));
  return result;
}

Type shape(int rows, int columns, const Type& entry = Type::scalar()) {
  return Type::matrix(rows, columns, entry);
}

// Sum over all permutations: the definition.
Fraction leibniz(const Components& m, int n, Budget& budget) {
  std::vector<int> columns(static_cast<std::size_t>(n));
  std::iota(columns.begin(), columns.end(), 0);
  Fraction total;
  do {
    int inversions = 0;
    Fraction term{Rational{1}};
    for (std::size_t i = 0; i < columns.size(); ++i) {
      for (std::size_t j = i + 1; j < columns.size(); ++j) inversions += columns[i] > columns[j];
      term = product(term, m[i * columns.size() + static_cast<std::size_t>(columns[i])], budget);
    }
    total = inversions % 2 == 0 ? sum(total, term, budget) : difference(total, term, budget);
  } while (std::next_permutation(columns.begin(), columns.end()));
  return total;
}

}  // namespace

TEST_CASE("a determinant is the sum over permutations, multiplicative and alternating", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{70};
  for (int i = 0; i < 40; ++i) {
    const int n = 1 + static_cast<int>(random() % 4);
    const Components a = random_components(random, n * n);
    const Components b = random_components(random, n * n);
    const Fraction det_a = determinant(a, n, budget);
    CHECK(same(det_a, leibniz(a, n, budget)));
    CHECK(same(det_a, determinant(transposed(a, shape(n, n)), n, budget)));
    if (n <= 3) {
      const Components ab = matrix_product(a, shape(n, n), b, shape(n, n), budget);
      CHECK(same(determinant(ab, n, budget), product(det_a, determinant(b, n, budget), budget)));
    }
    if (n < 2) continue;
    Components swapped = a;
    std::swap_ranges(swapped.begin(), swapped.begin() + n, swapped.begin() + n);
    CHECK(same(determinant(swapped, n, budget), product(det_a, Rational{-1}, budget)));
    Components twice = a;
    std::copy(twice.begin(), twice.begin() + n, twice.begin() + n);
    CHECK(determinant(twice, n, budget).is_zero());
  }
}

TEST_CASE("products of matrices are associative and turn round when transposed", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{71};
  for (int i = 0; i < 40; ++i) {
    const auto extent = [&] { return 1 + static_cast<int>(random() % 3); };
    const int p = extent();
    const int q = extent();
    const int r = extent();
    const int s = extent();
    const Components a = random_components(random, p * q);
    const Components b = random_components(random, q * r);
    const Components c = random_components(random, r * s);
    const Components ab = matrix_product(a, shape(p, q), b, shape(q, r), budget);
    const Components bc = matrix_product(b, shape(q, r), c, shape(r, s), budget);
    CHECK(same(matrix_product(ab, shape(p, r), c, shape(r, s), budget),
               matrix_product(a, shape(p, q), bc, shape(q, s), budget)));
    CHECK(same(transposed(ab, shape(p, r)),
               matrix_product(transposed(b, shape(q, r)), shape(r, q), transposed(a, shape(p, q)),
                              shape(q, p), budget)));
  }
}

TEST_CASE("a matrix of points is multiplied coordinate by coordinate", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{72};
  const Type points = shape(2, 3, Type::point(2));
  for (int i = 0; i < 20; ++i) {
    const Components row = random_components(random, 2);
    const Components net = random_components(random, 12);
    const Components column = random_components(random, 3);
    const Components left = matrix_product(row, shape(1, 2), net, points, budget);
    const Components whole =
        matrix_product(left, shape(1, 3, Type::point(2)), column, shape(3, 1), budget);
    REQUIRE(whole.size() == 2);
    for (std::size_t coordinate = 0; coordinate < 2; ++coordinate) {
      Fraction expected;
      for (std::size_t r = 0; r < 2; ++r)
        for (std::size_t c = 0; c < 3; ++c)
          expected = sum(expected,
                         product(product(row[r], column[c], budget),
                                 net[(r * 3 + c) * 2 + coordinate], budget),
                         budget);
      CHECK(same(whole[coordinate], expected));
    }
  }
}

TEST_CASE("dot and cross products obey their laws", "[law]") {
  Budget budget{Limits{}};
  std::mt19937 random{73};
  for (int i = 0; i < 40; ++i) {
    const Components a = random_components(random, 3);
    const Components b = random_components(random, 3);
    const Components c = random_components(random, 3);
    const Components ab = cross(a, b, budget);
    CHECK(dot(a, ab, budget).is_zero());
    CHECK(dot(b, ab, budget).is_zero());
    for (const Fraction& f : cross(a, a, budget)) CHECK(f.is_zero());
    // Lagrange: |a x b|^2 = |a|^2 |b|^2 - (a.b)^2
    const Fraction squares = product(dot(a, a, budget), dot(b, b, budget), budget);
    const Fraction mixed = dot(a, b, budget);
    CHECK(same(dot(ab, ab, budget), difference(squares, product(mixed, mixed, budget), budget)));
    // The triple product is the determinant: this fixes the orientation.
    Components rows = a;
    rows.insert(rows.end(), b.begin(), b.end());
    rows.insert(rows.end(), c.begin(), c.end());
    CHECK(same(dot(ab, c, budget), determinant(rows, 3, budget)));
  }
}

TEST_CASE("a block is the part between its rows and columns, ends included") {
  Components m;
  for (int k = 0; k < 12; ++k) m.emplace_back(Rational{k});
  const Components part = block(m, shape(3, 4), 1, 2, 1, 3);
  Components expected;
  for (const int k : {5, 6, 7, 9, 10, 11}) expected.emplace_back(Rational{k});
  CHECK(same(part, expected));
  // Entries of two components: entry (1, 0) of a 2 x 3 net.
  CHECK(same(block(m, shape(2, 3, Type::point(2)), 1, 1, 0, 0),
             Components{Rational{6}, Rational{7}}));
}

}  // namespace patchproof
