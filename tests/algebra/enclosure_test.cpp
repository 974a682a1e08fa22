#include <patchproof/algebra/enclosure.hpp>

#include <catch2/catch.hpp>
#include <ostream>
#include <random>
#include <stdexcept>

using patchproof::contains;
using patchproof::Enclosure;
using patchproof::exactly;
using patchproof::Rational;
using patchproof::to_decimal;

namespace {

Rational random_number(std::mt19937& random, int largest) {
  const unsigned span = 2 * static_cast<unsigned>(largest) + 1;
  return {static_cast<int>(random() % span) - largest, 1 + static_cast<int>(random() % 12)};
}

Enclosure random_enclosure(std::mt19937& random, int largest) {
  const Rational a = random_number(random, largest);
  const Rational b = random_number(random, largest);
  return a < b ? Enclosure{a, b} : Enclosure{b, a};
}

Rational random_member(std::mt19937& random, const Enclosure& x) {
  return x.low + (x.high - x.low) * Rational{static_cast<int>(random() % 17), 16};
}

}  // namespace

TEST_CASE("sums, differences, products, quotients and powers of members are enclosed", "[law]") {
  std::mt19937 random{3};
  for (int i = 0; i < 500; ++i) {
    const Enclosure x = random_enclosure(random, 9);
    const Enclosure y = random_enclosure(random, 9);
    const Rational a = random_member(random, x);
    const Rational b = random_member(random, y);
    const long n = static_cast<long>(random() % 11) - 4;
    INFO("[" << x.low << ", " << x.high << "] and [" << y.low << ", " << y.high << "], members "
             << a << " and " << b << ", exponent " << n);
    CHECK(contains(x + y, a + b));
    CHECK(contains(x - y, a - b));
    CHECK(contains(-x, -a));
    CHECK(contains(x * y, a * b));
    if (!contains(y, 0)) {
      CHECK(contains(x / y, a / b));
    }
    if (n >= 0 || !contains(x, 0)) {
      const Enclosure result = power(x, n);
      CHECK(contains(result, patchproof::power(a, n)));
      CHECK(result.low <= result.high);
    }
  }
}

TEST_CASE("an even power of an enclosure around zero starts at zero") {
  const Enclosure square = power(Enclosure{-2, 1}, 2);
  CHECK(square.low == 0);
  CHECK(square.high == 4);
  const Enclosure one = power(Enclosure{-2, 1}, 0);
  CHECK(one.low == 1);
  CHECK(one.high == 1);
}

TEST_CASE("nothing is divided by an enclosure that contains zero", "[reject]") {
  CHECK_THROWS_AS((exactly(1) / Enclosure{0, 1}), std::domain_error);
  CHECK_THROWS_WITH((exactly(1) / Enclosure{-1, 1}), "division by an enclosure that contains zero");
  CHECK_THROWS_WITH(power(Enclosure{-1, 0}, -1),
                    "a negative power of an enclosure that contains zero");
}

TEST_CASE("rounding goes outward, by less than the last digit", "[law]") {
  std::mt19937 random{4};
  for (int i = 0; i < 300; ++i) {
    const Enclosure x = random_enclosure(random, 50);
    const unsigned bits = static_cast<unsigned>(random() % 12);
    const Enclosure y = rounded(x, bits);
    const Rational step = patchproof::power(2, -static_cast<long>(bits));
    INFO("[" << x.low << ", " << x.high << "] to " << bits << " digits");
    CHECK(y.low <= x.low);
    CHECK(y.high >= x.high);
    CHECK(x.low - y.low < step);
    CHECK(y.high - x.high < step);
    CHECK(denominator(Rational{y.low / step}) == 1);
    CHECK(denominator(Rational{y.high / step}) == 1);
  }
}

TEST_CASE("an enclosure has the sign all its members have") {
  CHECK(sign(Enclosure{1, 2}) == 1);
  CHECK(sign(Enclosure{-2, -1}) == -1);
  CHECK(sign(exactly(0)) == 0);
  CHECK_FALSE(sign(Enclosure{0, 1}));
  CHECK_FALSE(sign(Enclosure{-1, 0}));
  CHECK_FALSE(sign(Enclosure{-1, 1}));
}

TEST_CASE("decimal digits are printed as far as they are certain") {
  CHECK(to_decimal(patchproof::square_root(exactly(2), 64), 8) == "1.41421356…");
  CHECK(to_decimal(exactly(Rational(1, 2)), 5) == "0.5");
  CHECK(to_decimal(exactly(Rational(-1, 3)), 5) == "-0.33333…");
  CHECK(to_decimal(exactly(-100), 0) == "-100");
  CHECK(to_decimal(exactly(Rational(7, 2)), 0) == "3…");
  CHECK(to_decimal(exactly(0), 4) == "0");
  CHECK(to_decimal({Rational(31, 10), Rational(314, 100)}, 6) == "3.1…");
  CHECK(to_decimal({Rational(-314, 100), Rational(-31, 10)}, 6) == "-3.1…");
}

TEST_CASE("an enclosure whose members share no digit is printed by its ends") {
  CHECK(to_decimal({Rational(19999, 10000), Rational(20001, 10000)}, 3) == "[1.999, 2.001]");
  CHECK(to_decimal({-1, 2}, 3) == "[-1, 2]");
  CHECK(to_decimal({Rational(-3, 2), Rational(152, 100)}, 3) == "[-1.5, 1.52]");
  CHECK(to_decimal({Rational(-1, 3), Rational(1, 4)}, 3) == "[-0.334, 0.25]");
  CHECK(to_decimal({Rational(9), Rational(10)}, 0) == "[9, 10]");
}

TEST_CASE("digits of a tiny enclosure around zero are zeros") {
  CHECK(to_decimal({Rational(-1, 100000), Rational(1, 100000)}, 3) == "0.000…");
  CHECK(to_decimal({Rational(-1, 1000), Rational(2, 1000)}, 3) == "0.00…");
}
