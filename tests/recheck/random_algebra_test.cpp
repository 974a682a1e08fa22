#include <catch2/catch.hpp>
#include <random>

#include <recheck/basis.hpp>
#include <recheck/calculus.hpp>
#include <recheck/interval.hpp>

using namespace recheck;

namespace {

/// A field with the scalars x, y, z and a smooth function f of one argument.
struct Setting {
  std::vector<Symbol> symbols;
  Meter meter{Limits{}};
  Field field{symbols, meter};

  Setting() {
    for (const char* name : {"x", "y", "z"})
      symbols.push_back({name, Symbol::Role::scalar, {}, 0, symbols.size()});
    Type function;
    function.arguments = 1;
    symbols.push_back({"f", Symbol::Role::function, function, 5, 3});
  }
  Quotient letter(SymbolIndex k) { return of_atom(field.coordinate(k, 0)); }
};

/// A polynomial in the letters with small coefficients.
Quotient random_polynomial(Setting& s, std::mt19937& seed) {
  Quotient result;
  for (int k = 0; k < 3; ++k) {
    Quotient term =
        number(Rational{static_cast<int>(seed() % 7) - 3, 1 + static_cast<int>(seed() % 3)});
    for (SymbolIndex letter = 0; letter < 3; ++letter)
      term = s.field.product(term, s.field.power(s.letter(letter), seed() % 3));
    result = s.field.sum(result, term);
  }
  return result;
}

bool equal(Setting& s, const Quotient& a, const Quotient& b) {
  return s.field.difference(a, b).numerator.empty();
}

}  // namespace

TEST_CASE("The second checker's fractions are a field", "[law]") {
  std::mt19937 seed{20};
  for (int round = 0; round < 30; ++round) {
    Setting s;
    const Quotient a = random_polynomial(s, seed);
    const Quotient b = s.field.sum(random_polynomial(s, seed), number(11));
    const Quotient c = random_polynomial(s, seed);
    INFO("a = " << s.field.text(a) << ", b = " << s.field.text(b) << ", c = " << s.field.text(c));
    const Quotient ab = s.field.product(a, s.field.inverse(b));
    CHECK(equal(s, s.field.product(ab, b), a));
    CHECK(equal(s, s.field.product(s.field.sum(ab, c), b), s.field.sum(a, s.field.product(b, c))));
    CHECK(equal(s, s.field.power(ab, 3), s.field.product(ab, s.field.product(ab, ab))));
    const Quotient product = s.field.product(b, c);
    const auto quotient = exact_quotient(product.numerator, b.numerator, s.meter);
    REQUIRE(quotient);
    CHECK(*quotient == c.numerator);
  }
}

TEST_CASE("The second checker differentiates products, quotients and functions of functions",
          "[law]") {
  std::mt19937 seed{21};
  for (int round = 0; round < 30; ++round) {
    Setting s;
    Field& field = s.field;
    const Atom x = field.coordinate(0, 0);
    const auto d = [&](const Quotient& a) { return derivative(a, x, field); };
    const auto f = [&](std::size_t order, const Quotient& at) {
      return of_atom(field.jet(3, 0, {order}, {at}));
    };
    const Quotient a = random_polynomial(s, seed);
    const Quotient b = field.sum(random_polynomial(s, seed), number(11));
    const Quotient fa = f(0, a);
    INFO("a = " << field.text(a) << ", b = " << field.text(b));
    CHECK(equal(s, d(field.product(fa, b)),
                field.sum(field.product(d(fa), b), field.product(fa, d(b)))));
    CHECK(equal(s, d(fa), field.product(f(1, a), d(a))));
    const Quotient ratio = field.product(fa, field.inverse(b));
    CHECK(equal(s, field.product(d(ratio), field.product(b, b)),
                field.difference(field.product(d(fa), b), field.product(fa, d(b)))));
    // Putting a value in before and after a derivative in another letter.
    const Images images{{field.coordinate(1, 0), b}};
    const Quotient in_z = field.product(fa, s.letter(2));
    const Quotient independent = substituted(random_polynomial(s, seed), {{x, number(2)}}, field);
    CHECK(equal(
        s, substituted(field.product(in_z, independent), images, field),
        field.product(substituted(in_z, images, field), substituted(independent, images, field))));
    // The integral of a derivative is the difference of the values at the ends.
    const Quotient whole = integral(d(a), x, number(-1), b, field);
    CHECK(equal(s, whole,
                field.difference(substituted(a, {{x, b}}, field),
                                 substituted(a, {{x, number(-1)}}, field))));
  }
}

TEST_CASE("Functions at equal arguments are equal, however these are written", "[law]") {
  Setting s;
  Field& field = s.field;
  const Quotient sum = field.sum(s.letter(0), s.letter(1));
  const Quotient difference = field.difference(s.letter(0), s.letter(1));
  const Quotient written = field.product(field.product(sum, difference), field.inverse(difference));
  CHECK(field.jet(3, 0, {0}, {sum}) == field.jet(3, 0, {0}, {written}));
  CHECK(field.jet(3, 0, {0}, {sum}) != field.jet(3, 0, {0}, {difference}));
  CHECK_THROWS_WITH(field.jet(3, 0, {6}, {sum}),
                    "a derivative of order 6 of 'f', which is only assumed C^5");
}

TEST_CASE("Basis functions of the second checker sum to one", "[law]") {
  const auto sum_of = [](const std::vector<Coefficients>& all) {
    Coefficients sum;
    for (const Coefficients& one : all)
      for (std::size_t k = 0; k < one.size(); ++k) {
        if (sum.size() <= k) sum.resize(k + 1, Rational{0});
        sum[k] += one[k];
      }
    while (!sum.empty() && sum.back() == 0) sum.pop_back();
    return sum;
  };
  for (std::size_t n = 0; n < 6; ++n) {
    std::vector<Coefficients> all;
    for (std::size_t i = 0; i <= n; ++i) all.push_back(bernstein(n, i));
    CHECK(sum_of(all) == Coefficients{1});
  }
  const std::vector<Rational> knots{0, 0, 0, 0, 1, {3, 2}, {3, 2}, 4, 4, 4, 4};
  for (const std::size_t span : {3U, 4U, 6U}) {
    std::vector<Coefficients> all;
    for (std::size_t i = 0; i + 4 < knots.size(); ++i)
      all.push_back(bspline_basis(3, i, span, knots));
    CHECK(sum_of(all) == Coefficients{1});
  }
}

TEST_CASE("Square roots of numbers have one form, and a sign", "[law]") {
  Setting s;
  Field& field = s.field;
  for (int n = 0; n < 50; ++n) {
    const Quotient root = field.square_root({n, 7});
    CHECK(equal(s, field.product(root, root), number({n, 7})));
  }
  CHECK(equal(s, field.product(field.square_root(2), field.square_root(3)), field.square_root(6)));
  CHECK(equal(s, field.square_root({8, 9}), field.multiple(field.square_root(2), {2, 3})));
  CHECK(sign(field.difference(field.square_root(2), number({141421356, 100000000})), field) == 1);
  CHECK(sign(field.difference(field.square_root(2), number({141421357, 100000000})), field) == -1);
  CHECK_THROWS_WITH(field.square_root(-1), "the square root of the negative number -1");
}
