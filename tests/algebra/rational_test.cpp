#include <patchproof/algebra/rational.hpp>

#include <catch2/catch.hpp>
#include <random>
#include <sstream>
#include <vector>

namespace patchproof {
namespace {

using Reference = boost::multiprecision::cpp_rational;

Reference reference(const Rational& a) { return Reference{numerator(a), denominator(a)}; }

// Numbers around every bound of the representation, and random ones of all lengths.
std::vector<Rational> samples() {
  std::vector<Integer> whole{0, 1, 2, 3, 6, 10};
  for (const unsigned bits : {31U, 32U, 62U, 63U, 64U, 127U, 128U})
    for (const int off : {-1, 0, 1}) whole.push_back((Integer{1} << bits) + off);
  std::mt19937_64 random{2026};
  for (int k = 0; k < 20; ++k) whole.push_back(Integer{random() >> (random() % 64)});
  std::vector<Rational> result;
  for (const Integer& top : whole)
    for (int k = 0; k < 4; ++k) {
      const Integer bottom = k == 0 ? Integer{1} : whole[1 + random() % (whole.size() - 1)];
      result.emplace_back(top, bottom);
      result.emplace_back(Integer{-top}, bottom);
    }
  return result;
}

// The same value has the same representation, and the smallest that it can have.
void check_canonical(const Rational& a, const Reference& expected) {
  REQUIRE(numerator(a) == boost::multiprecision::numerator(expected));
  REQUIRE(denominator(a) == boost::multiprecision::denominator(expected));
  const Integer bound = std::numeric_limits<std::int64_t>::max();
  REQUIRE(a.is_small() == (abs(numerator(a)) <= bound && denominator(a) <= bound));
  REQUIRE(a == Rational{numerator(a), denominator(a)});
}

}  // namespace

TEST_CASE("fractions calculate as those of Boost do, at every bound of a machine word") {
  const std::vector<Rational> all = samples();
  for (const Rational& a : all)
    for (const Rational& b : all) {
      const Reference x = reference(a);
      const Reference y = reference(b);
      INFO(a << " and " << b);
      check_canonical(a + b, x + y);
      check_canonical(a - b, x - y);
      check_canonical(a * b, x * y);
      if (b.sign() != 0) check_canonical(a / b, x / y);
      REQUIRE((a == b) == (x == y));
      REQUIRE((a < b) == (x < y));
      REQUIRE((a > b) == (x > y));
    }
}

TEST_CASE("a fraction calculates with itself, is copied, negated and given a new value") {
  for (const Rational& a : samples()) {
    const Reference x = reference(a);
    Rational b = a;
    b += b;
    check_canonical(b, x + x);
    b = a;
    b -= b;
    check_canonical(b, 0);
    b = a;
    b *= b;
    check_canonical(b, x * x);
    if (a.sign() != 0) {
      b = a;
      b /= b;
      check_canonical(b, 1);
    }
    check_canonical(-a, -x);
    check_canonical(abs(a), x < 0 ? Reference{-x} : x);
    CHECK(a.sign() == x.sign());
    CHECK((floor(a) <= a && a < floor(a) + 1));
    Rational c = std::move(b);
    b = a;
    c = b;
    check_canonical(c, x);
  }
}

TEST_CASE("every machine word is a fraction") {
  check_canonical(std::numeric_limits<std::int64_t>::min(),
                  Reference{std::numeric_limits<std::int64_t>::min()});
  check_canonical(std::numeric_limits<std::int64_t>::max(),
                  Reference{std::numeric_limits<std::int64_t>::max()});
  check_canonical(std::numeric_limits<std::uint64_t>::max(),
                  Reference{std::numeric_limits<std::uint64_t>::max()});
  check_canonical(Rational{6, -4}, Reference{-3, 2});
  check_canonical(Rational{std::numeric_limits<std::int64_t>::min(), 2},
                  Reference{std::numeric_limits<std::int64_t>::min() / 2});
  CHECK(Rational{} == 0);
}

TEST_CASE("a negative denominator is turned, however long it is") {
  const Integer large = Integer{1} << 200;
  CHECK(Rational{Integer{3}, Integer{-6}} == Rational{-1, 2});
  CHECK(Rational{large, Integer{-large * 2}} == Rational{-1, 2});
  CHECK(Rational{Integer{-1}, Integer{-large}} == Rational{Integer{1}, large});
  CHECK(denominator(Rational{Integer{5}, Integer{-large}}) == large);
}

TEST_CASE("no number is divided by zero") {
  const std::string message = "division by zero";
  CHECK_THROWS_WITH((Rational{Integer{1}, Integer{0}}), message);
  CHECK_THROWS_WITH((Rational{1, 0}), message);
  Rational a = 1;
  CHECK_THROWS_WITH(a /= 0, message);
  CHECK(a == 1);
}

TEST_CASE("fractions are written as p/q") {
  std::ostringstream out;
  out << Rational{-3, 6} << ' ' << Rational{7} << ' ' << Rational{Integer{1} << 70};
  CHECK(out.str() == "-1/2 7 1180591620717411303424");
}

}  // namespace patchproof
