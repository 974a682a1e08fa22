#include <patchproof/symbolic/components.hpp>

#include <catch2/catch.hpp>
#include <vector>

#include <tests/symbolic/terms.hpp>

using namespace patchproof;
using namespace patchproof::terms;

namespace {

// Operations on matrices and points, written as the language would.
Term determinant(const Term& m) { return make_term(Operation::determinant, Type::scalar(), {m}); }
Term transpose(const Term& m) {
  return make_term(Operation::transpose,
                   Type::matrix(m.type().columns, m.type().rows, *m.type().inner), {m});
}
Term slice(const Term& m, int i0, int i1, int j0, int j1) {
  return make_term(Operation::slice, Type::matrix(i1 - i0 + 1, j1 - j0 + 1, *m.type().inner), {m},
                   Indices{i0, i1, j0, j1});
}
Term entry(const Term& m, int i, int j) {
  return make_term(Operation::entry, *m.type().inner, {m}, Indices{i, j});
}
Term dot(const Term& a, const Term& b) { return make_term(Operation::dot, Type::scalar(), {a, b}); }
Term cross(const Term& a, const Term& b) { return make_term(Operation::cross, a.type(), {a, b}); }

std::vector<Term> scalars(Declarations& declare, int count) {
  std::vector<Term> result;
  for (int i = 0; i < count; ++i) result.push_back(declare.scalar("m" + std::to_string(i)));
  return result;
}

}  // namespace

TEST_CASE("a 3 x 3 determinant is given by the rule of Sarrus, with symbols and with numbers") {
  Declarations declare;
  const std::vector<Term> m = scalars(declare, 9);
  const auto sarrus = [](const std::vector<Term>& x) {
    return x[0] * x[4] * x[8] + x[1] * x[5] * x[6] + x[2] * x[3] * x[7] - x[2] * x[4] * x[6] -
           x[0] * x[5] * x[7] - x[1] * x[3] * x[8];
  };
  CHECK(holds(determinant(matrix(3, 3, m)), sarrus(m)));
  std::vector<Term> numbers;
  for (const long n : {2, -1, 3, 0, 5, 7, -4, 1, 6}) numbers.push_back(number(n));
  CHECK(holds(determinant(matrix(3, 3, numbers)), sarrus(numbers)));
  CHECK(fails(determinant(matrix(3, 3, m)), -sarrus(m)));
}

TEST_CASE("a determinant does not change with transposition and vanishes for equal rows") {
  Declarations declare;
  std::vector<Term> m = scalars(declare, 16);
  CHECK(holds(determinant(matrix(4, 4, m)), determinant(transpose(matrix(4, 4, m)))));
  for (std::size_t j = 0; j < 4; ++j) m[4 + j] = m[12 + j];
  CHECK(holds(determinant(matrix(4, 4, m)), number(0)));
}

TEST_CASE("a determinant with too many symbolic rows is given up") {
  Declarations declare;
  const Term m = matrix(13, 13, scalars(declare, 169));
  CHECK(reason(determinant(m), number(0)) ==
        "over budget: a determinant of more than a dozen rows");
}

TEST_CASE("transposing a product transposes and exchanges the factors") {
  Declarations declare;
  const std::vector<Term> m = scalars(declare, 12);
  const Term a = matrix(2, 3, {m[0], m[1], m[2], m[3], m[4], m[5]});
  std::vector<Term> points;
  for (int i = 0; i < 6; ++i) points.push_back(declare.point("P" + std::to_string(i), 2));
  const Term p = matrix(3, 2, points);
  CHECK(holds(transpose(times(a, p)), times(transpose(p), transpose(a))));
  CHECK(holds(entry(times(a, p), 1, 0), m[3] * points[0] + m[4] * points[2] + m[5] * points[4]));
  CHECK(holds(entry(transpose(p), 1, 2), points[5]));
  CHECK(holds(slice(p, 1, 2, 1, 1), matrix(2, 1, {points[3], points[5]})));
  CHECK(fails(slice(p, 1, 2, 1, 1), matrix(2, 1, {points[2], points[4]})));
}

TEST_CASE("dot and cross products satisfy the identities of Lagrange and Jacobi") {
  Declarations declare;
  const Term a = declare.point("a", 3);
  const Term b = declare.point("b", 3);
  const Term c = declare.point("c", 3);
  CHECK(holds(dot(cross(a, b), cross(a, b)), dot(a, a) * dot(b, b) - power(dot(a, b), 2)));
  CHECK(holds(cross(a, cross(b, c)) + cross(b, cross(c, a)) + cross(c, cross(a, b)), 0 * a));
  CHECK(holds(dot(a, cross(a, b)), number(0)));
  CHECK(holds(component(cross(a, b), 2),
              component(a, 0) * component(b, 1) - component(a, 1) * component(b, 0)));
  CHECK(fails(cross(a, b), cross(b, a)));
}

TEST_CASE("values whose shapes do not fit have no opinion", "[reject]") {
  Declarations declare;
  const Term a = declare.point("a", 3);
  const Term b = declare.point("b", 2);
  CHECK(reason(a, b) == "a sum of values of different shapes");
  CHECK(reason(cross(b, b), b) == "a cross product of points not in space");
  CHECK(reason(a * b, b) == "a product of two values with several components");
  CHECK(reason(slice(matrix(1, 1, {a}), 0, 1, 0, 0), a) == "a slice outside the matrix");
}
