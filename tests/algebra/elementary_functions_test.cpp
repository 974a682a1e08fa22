#include <catch2/catch.hpp>
#include <random>
#include <stdexcept>

#include <patchproof/algebra/enclosure.hpp>

using patchproof::contains;
using patchproof::cosine;
using patchproof::Enclosure;
using patchproof::exactly;
using patchproof::exponential;
using patchproof::number_from_text;
using patchproof::pi_enclosure;
using patchproof::Rational;
using patchproof::sine;
using patchproof::square_root;

namespace {

Rational random_number(std::mt19937& random, int largest) {
  const unsigned span = 2 * static_cast<unsigned>(largest) + 1;
  return {static_cast<int>(random() % span) - largest, 1 + static_cast<int>(random() % 12)};
}

Rational unit(unsigned bits) { return patchproof::power(2, -static_cast<long>(bits)); }

bool overlap(const Enclosure& a, const Enclosure& b) { return a.low <= b.high && b.low <= a.high; }

// Whether a has no member further than `slack` outside b.
bool inside(const Enclosure& a, const Enclosure& b, const Rational& slack) {
  return b.low - slack <= a.low && a.high <= b.high + slack;
}

// The enclosure contains a number whose decimal digits start so.
void check_digits(const Enclosure& enclosure, const std::string& digits) {
  const bool negative = digits[0] == '-';
  Rational least = number_from_text(digits.substr(negative ? 1 : 0)).value();
  const std::size_t places = digits.size() - digits.find('.') - 1;
  Rational most = least + patchproof::power(10, -static_cast<long>(places));
  INFO("digits " << digits);
  CHECK(overlap(negative ? -enclosure : enclosure, {least, most}));
  CHECK(enclosure.high - enclosure.low < unit(100));
}

}  // namespace

// Abramowitz & Stegun, Handbook of Mathematical Functions, tables 1.1, 4.4, 4.6.
TEST_CASE("the functions have the values of the tables", "[literature]") {
  check_digits(pi_enclosure(101), "3.14159265358979323846");
  check_digits(square_root(exactly(2), 101), "1.41421356237309504880");
  check_digits(exponential(exactly(1), 101), "2.71828182845904523536");
  check_digits(exponential(exactly(-1), 101), "0.36787944117144232159");
  check_digits(sine(exactly(1), 101), "0.84147098480789650665");
  check_digits(cosine(exactly(1), 101), "0.54030230586813971740");
  check_digits(sine(exactly(10), 101), "-0.54402111088936981340");
  check_digits(cosine(exactly(-3), 101), "-0.98999249660044545727");
}

TEST_CASE("one number gets an enclosure narrower than asked, nested as precision grows", "[law]") {
  std::mt19937 random{5};
  for (int i = 0; i < 40; ++i) {
    const Rational x = random_number(random, 60);
    for (const unsigned bits : {0U, 1U, 20U, 64U, 300U}) {
      INFO("x = " << x << ", bits = " << bits);
      const unsigned finer = bits + 40;
      const Rational magnitude = abs(x);
      CHECK(pi_enclosure(bits).high - pi_enclosure(bits).low <= 2 * unit(bits));
      CHECK(overlap(pi_enclosure(bits), pi_enclosure(finer)));
      for (const auto& f : {sine, cosine, exponential}) {
        const Enclosure value = f(exactly(x), bits);
        const Enclosure finer_value = f(exactly(x), finer);
        CHECK(value.low <= value.high);
        CHECK(value.high - value.low <= unit(bits));
        CHECK(overlap(value, finer_value));
        CHECK(inside(finer_value, value, unit(finer)));
        CHECK(patchproof::bit_length(value.low) <= bits + 100);
      }
      const Enclosure root = square_root(exactly(magnitude), bits);
      CHECK(root.high - root.low <= unit(bits));
      CHECK(contains(power(root, 2), magnitude));
    }
  }
}

TEST_CASE("sin^2 x + cos^2 x = 1", "[law]") {
  std::mt19937 random{6};
  for (int i = 0; i < 200; ++i) {
    const Rational x = random_number(random, i < 100 ? 10 : 1'000'000);
    INFO("x = " << x);
    const Enclosure sum = power(sine(exactly(x), 80), 2) + power(cosine(exactly(x), 80), 2);
    CHECK(contains(sum, 1));
    CHECK(sum.high - sum.low < unit(70));
  }
}

TEST_CASE("sin(x + y) = sin x cos y + cos x sin y, and sine is odd", "[law]") {
  std::mt19937 random{7};
  for (int i = 0; i < 200; ++i) {
    const Rational x = random_number(random, 30);
    const Rational y = random_number(random, 3000);
    INFO("x = " << x << ", y = " << y);
    const Enclosure left = sine(exactly(x + y), 80);
    const Enclosure right = sine(exactly(x), 80) * cosine(exactly(y), 80) +
                            cosine(exactly(x), 80) * sine(exactly(y), 80);
    CHECK(overlap(left, right));
    CHECK(right.high - right.low < unit(70));
    CHECK(overlap(-sine(exactly(x), 80), sine(exactly(-x), 80)));
  }
}

TEST_CASE("exp(a) exp(b) = exp(a + b)", "[law]") {
  std::mt19937 random{8};
  for (int i = 0; i < 100; ++i) {
    const Rational a = random_number(random, 20);
    const Rational b = random_number(random, 20);
    INFO("a = " << a << ", b = " << b);
    const Enclosure product = exponential(exactly(a), 120) * exponential(exactly(b), 120);
    CHECK(overlap(product, exponential(exactly(a + b), 120)));
    CHECK(product.high - product.low < unit(55));
  }
}

TEST_CASE("a wider argument has the values of the narrower among its values", "[law]") {
  std::mt19937 random{9};
  for (int i = 0; i < 150; ++i) {
    const Rational low = random_number(random, 20);
    const Rational high = low + abs(random_number(random, 5));
    const Rational third = (2 * low + high) / 3;
    const Enclosure wide{low, high};
    INFO("[" << low << ", " << high << "]");
    for (const auto& f : {sine, cosine, exponential}) {
      CHECK(inside(f({low, third}, 40), f(wide, 40), unit(40)));
      CHECK(inside(f(exactly(third), 90), f(wide, 40), 0));
      CHECK(inside(f(exactly(high), 90), f(wide, 40), 0));
    }
    if (low >= 0) {
      CHECK(inside(square_root(exactly(third), 90), square_root(wide, 40), 0));
    }
  }
}

TEST_CASE("between its ends a wave reaches its extrema, and nothing beyond") {
  const Enclosure hill = sine({1, 2}, 40);
  CHECK(hill.high == 1);
  CHECK(inside({hill.low, hill.low}, sine(exactly(1), 60), unit(40)));
  const Enclosure valley = cosine({3, 4}, 40);
  CHECK(valley.low == -1);
  CHECK(valley.high < 0);
  const Enclosure both = sine({-2, 2}, 40);
  CHECK(both.low == -1);
  CHECK(both.high == 1);
  const Enclosure endless = cosine({-1000, 1000}, 40);
  CHECK(endless.low == -1);
  CHECK(endless.high == 1);
  const Enclosure slope = sine({-1, 1}, 40);
  CHECK(slope.low > -1);
  CHECK(slope.high < 1);
  const Enclosure around_zero = cosine({-1, 1}, 40);
  CHECK(around_zero.high == 1);
  CHECK(around_zero.low > 0);
}

TEST_CASE("sin pi cannot be told from zero, sin 3 can") {
  CHECK_FALSE(sign(sine(pi_enclosure(200), 200)));
  CHECK(sine(pi_enclosure(200), 200).high < unit(190));
  CHECK(sign(sine(exactly(3), 20)) == 1);
  CHECK(sign(cosine(pi_enclosure(50) / exactly(3), 50) - exactly(Rational(1, 2))) == std::nullopt);
}

TEST_CASE("values at zero and roots of squares are exact") {
  CHECK(sign(sine(exactly(0), 10)) == 0);
  CHECK(cosine(exactly(0), 10).low == 1);
  CHECK(cosine(exactly(0), 10).high == 1);
  CHECK(exponential(exactly(0), 10).low == 1);
  const Enclosure root = square_root(exactly(Rational(4, 9)), 10);
  CHECK(root.low == Rational(2, 3));
  CHECK(root.high == Rational(2, 3));
  CHECK(sign(square_root(exactly(0), 10)) == 0);
}

TEST_CASE("the square root leaves out negative members") {
  const Enclosure root = square_root({-4, 9}, 10);
  CHECK(root.low == 0);
  CHECK(root.high == 3);
}

TEST_CASE("large arguments have values too") {
  const Rational huge = patchproof::power(10, 1000) + Rational(1, 7);
  const Enclosure sum = power(sine(exactly(huge), 60), 2) + power(cosine(exactly(huge), 60), 2);
  CHECK(contains(sum, 1));
  CHECK(sum.high - sum.low < unit(50));
  // 22 = 7 pi + 0.0088...: the most famous near miss.
  check_digits(sine(exactly(22), 101), "-0.00885130929040387592");
  const Enclosure tower = exponential(exactly(10'000), 20);
  CHECK(tower.high - tower.low <= unit(20));
  CHECK(overlap(power(exponential(exactly(5000), 7500), 2), tower));
}

TEST_CASE("far below zero the exponential is between zero and next to nothing") {
  const Enclosure value = exponential({-1'000'000, -20'000}, 50);
  CHECK(value.low == 0);
  CHECK(value.high <= unit(50));
  CHECK(exponential({-1'000'000, 0}, 50).high == 1);
}

TEST_CASE("arguments without a value or too large are refused", "[reject]") {
  CHECK_THROWS_WITH(square_root({-2, -1}, 10), "the square root of a negative number");
  CHECK_THROWS_WITH(exponential(exactly(10'001), 10), "the exponential of a number above 10000");
  CHECK_THROWS_WITH(sine(exactly(patchproof::power(2, 100'001)), 10),
                    "the argument of a sine or cosine is too large");
  CHECK_THROWS_WITH(pi_enclosure(100'001), "more than 100000 binary digits");
  CHECK_THROWS_AS(sine(exactly(1), ~0U), std::domain_error);
}
