#include <patchproof/algebra/number.hpp>

#include <catch2/catch.hpp>
#include <climits>
#include <random>
#include <stdexcept>

using patchproof::Integer;
using patchproof::number_from_text;
using patchproof::Rational;

TEST_CASE("decimal text is read as an exact fraction") {
  CHECK(number_from_text("0") == Rational{0});
  CHECK(number_from_text("0.1") == Rational(1, 10));
  CHECK(number_from_text("010") == Rational{10});
  CHECK(number_from_text("00.50") == Rational(1, 2));
  CHECK(number_from_text("3.14159") == Rational(314159, 100000));
  CHECK(number_from_text("123456789012345678901234567890") ==
        Rational{Integer{"123456789012345678901234567890"}});
}

TEST_CASE("only digits with at most one point inside are a number", "[reject]") {
  for (const char* text : {"", ".", "1.", ".5", "1e3", "-1", "+1", " 1", "1 ", "0x10", "1.2.3",
                           "1/2", "1,5", "a", "\xC3\xA9"}) {
    INFO("text: '" << text << "'");
    CHECK_FALSE(number_from_text(text));
  }
  CHECK_FALSE(number_from_text(std::string_view{"1\0", 2}));
}

TEST_CASE("the longest number is read and a longer one rejected", "[reject]") {
  const std::string nines(patchproof::longest_number, '9');
  const std::optional<Rational> number = number_from_text(nines);
  REQUIRE(number);
  CHECK(*number == patchproof::power(10, 10'000) - 1);
  CHECK_FALSE(number_from_text(nines + "9"));
}

TEST_CASE("a number is written as p or p/q and read back", "[law]") {
  CHECK(patchproof::to_text(Rational(-6, 4)) == "-3/2");
  CHECK(patchproof::to_text(Rational{0}) == "0");
  std::mt19937 random{1};
  for (int i = 0; i < 200; ++i) {
    const Integer whole = Integer{random()} * random() * random();
    INFO("number: " << whole);
    CHECK(number_from_text(patchproof::to_text(Rational{whole})) == Rational{whole});
  }
}

TEST_CASE("bit length is that of the larger of numerator and denominator") {
  CHECK(patchproof::bit_length(Rational{0}) == 0);
  CHECK(patchproof::bit_length(Rational{1}) == 1);
  CHECK(patchproof::bit_length(Rational{-8}) == 4);
  CHECK(patchproof::bit_length(Rational(1, 255)) == 8);
  CHECK(patchproof::bit_length(Rational(256, 255)) == 9);
}

TEST_CASE("exponents of powers of one number add", "[law]") {
  std::mt19937 random{2};
  for (int i = 0; i < 200; ++i) {
    const Rational base{static_cast<int>(random() % 41) - 20, 1 + static_cast<int>(random() % 9)};
    const long a = static_cast<long>(random() % 21) - 10;
    const long b = static_cast<long>(random() % 21) - 10;
    if (base == 0) continue;
    INFO("base " << base << ", exponents " << a << " and " << b);
    CHECK(patchproof::power(base, a) * patchproof::power(base, b) ==
          patchproof::power(base, a + b));
  }
}

TEST_CASE("powers of zero and one, and the least exponent there is") {
  CHECK(patchproof::power(0, 0) == 1);
  CHECK(patchproof::power(0, 5) == 0);
  CHECK(patchproof::power(1, LONG_MAX) == 1);
  CHECK(patchproof::power(-1, LONG_MIN) == 1);
  CHECK(patchproof::power(Rational(-2, 3), -3) == Rational(-27, 8));
}

TEST_CASE("zero has no negative power", "[reject]") {
  CHECK_THROWS_AS(patchproof::power(0, -1), std::domain_error);
  CHECK_THROWS_WITH(patchproof::power(0, -1), "a negative power of zero");
}
