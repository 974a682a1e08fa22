#include <patchproof/kernel/basis.hpp>

#include <catch2/catch.hpp>
#include <random>

namespace patchproof {

namespace {

Rational at(const std::vector<Rational>& coefficients, const Rational& t) {
  Rational result = 0;
  for (std::size_t k = coefficients.size(); k-- > 0;) result = result * t + coefficients[k];
  return result;
}

Rational binomial(int n, int k) {
  return k == 0 || k == n ? Rational{1} : binomial(n - 1, k - 1) + binomial(n - 1, k);
}

// The recursion of Cox and de Boor at a place of one knot span, 0/0 = 0.
// Piegl & Tiller, The NURBS Book, (2.5).
Rational recursion(const std::vector<Rational>& knots, int span, int index, int degree,
                   const Rational& x) {
  if (degree == 0) return index == span ? 1 : 0;
  const auto knot = [&](int i) { return knots[static_cast<std::size_t>(i)]; };
  const Rational rise = knot(index + degree) - knot(index);
  const Rational fall = knot(index + degree + 1) - knot(index + 1);
  Rational result = 0;
  if (rise != 0) result += (x - knot(index)) / rise * recursion(knots, span, index, degree - 1, x);
  if (fall != 0)
    result +=
        (knot(index + degree + 1) - x) / fall * recursion(knots, span, index + 1, degree - 1, x);
  return result;
}

// Knots that do not decrease, of multiplicities up to degree + 1, and not all equal.
std::vector<Rational> random_knots(std::mt19937& random, int degree, int points) {
  for (;;) {
    std::vector<Rational> knots{Rational(static_cast<int>(random() % 5), 3)};
    int multiplicity = 1;
    while (static_cast<int>(knots.size()) < points + degree + 1) {
      const bool again = multiplicity <= degree && random() % 2 == 0;
      multiplicity = again ? multiplicity + 1 : 1;
      knots.push_back(again
                          ? knots.back()
                          : Rational{knots.back() + Rational(1 + static_cast<int>(random() % 4),
                                                             1 + static_cast<int>(random() % 3))});
    }
    const auto p = static_cast<std::size_t>(degree);
    if (knots[p] < knots[knots.size() - 1 - p]) return knots;
  }
}

}  // namespace

TEST_CASE("Bernstein polynomials are C(n,i) t^i (1-t)^(n-i)", "[law]") {
  for (int n = 0; n <= 9; ++n) {
    for (int i = 0; i <= n; ++i) {
      for (const Rational& t : {Rational(0), Rational(1), Rational(2, 7), Rational(-3, 5)}) {
        const Rational expected = binomial(n, i) * power(t, i) * power(1 - t, n - i);
        INFO(n << " " << i << " " << to_text(t));
        CHECK(at(bernstein_coefficients(n, i), t) == expected);
      }
    }
  }
}

TEST_CASE("Bernstein polynomials of one degree sum to 1, and vanish for other indices", "[law]") {
  for (int n = 0; n <= 12; ++n) {
    Rational total = 0;
    for (int i = -1; i <= n + 1; ++i) total += at(bernstein_coefficients(n, i), Rational(5, 11));
    CHECK(total == 1);
    CHECK(at(bernstein_coefficients(n, -1), Rational(1, 2)) == 0);
    CHECK(at(bernstein_coefficients(n, n + 1), Rational(1, 2)) == 0);
  }
}

TEST_CASE("B-spline basis functions agree with the recursion, for any knots", "[law]") {
  std::mt19937 random{50};
  for (int i = 0; i < 80; ++i) {
    const int degree = static_cast<int>(random() % 5);
    const int points = degree + 1 + static_cast<int>(random() % 4);
    const std::vector<Rational> knots = random_knots(random, degree, points);
    for (int span = degree; span < points; ++span) {
      const Rational& low = knots[static_cast<std::size_t>(span)];
      const Rational& high = knots[static_cast<std::size_t>(span) + 1];
      if (low == high) continue;
      for (const Rational& t : {Rational(0), Rational(1), Rational(1, 3), Rational(3, 4)}) {
        Rational total = 0;
        for (int index = 0; index < points; ++index) {
          const Rational value = at(basis_coefficients({degree, index, span, knots}), t);
          const Rational x = (1 - t) * low + t * high;
          INFO("degree " << degree << ", index " << index << ", span " << span);
          CHECK(value == recursion(knots, span, index, degree, x));
          CHECK(value >= 0);
          const bool touches = index <= span && span <= index + degree;
          if (!touches) CHECK(value == 0);
          total += value;
        }
        // Partition of unity: holds inside the domain of any knots.
        CHECK(total == 1);
      }
    }
  }
}

TEST_CASE("over 0,..,0,1,..,1 the B-spline basis is the Bernstein basis", "[literature]") {
  // Piegl & Tiller, The NURBS Book, 2.2, property P2.
  for (int p = 1; p <= 6; ++p) {
    std::vector<Rational> knots(static_cast<std::size_t>(p) + 1, 0);
    knots.insert(knots.end(), static_cast<std::size_t>(p) + 1, 1);
    for (int i = 0; i <= p; ++i)
      CHECK(basis_coefficients({p, i, p, knots}) == bernstein_coefficients(p, i));
  }
}

TEST_CASE("the quadratic example of the NURBS book", "[literature]") {
  // Piegl & Tiller, The NURBS Book, example 2.2: U = {0,0,0,1,2,3,4,4,5,5,5}, p = 2;
  // N_{2,2} on [0,1) is u^2/2, on [1,2) -3/2 + 3u - u^2, on [2,3) (3-u)^2/2.
  const std::vector<Rational> knots{0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5};
  using Coefficients = std::vector<Rational>;
  CHECK(basis_coefficients({2, 2, 2, knots}) == Coefficients{0, 0, Rational(1, 2)});
  CHECK(basis_coefficients({2, 2, 3, knots}) == Coefficients{Rational(1, 2), 1, -1});
  CHECK(basis_coefficients({2, 2, 4, knots}) == Coefficients{Rational(1, 2), -1, Rational(1, 2)});
}

}  // namespace patchproof
