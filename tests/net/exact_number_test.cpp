#include <patchproof/net/exact_number.hpp>

#include <catch2/catch.hpp>
#include <cstdio>
#include <random>
#include <string>

#include <patchproof/algebra/number.hpp>
#include <patchproof/net/net_fault.hpp>

using namespace patchproof;

namespace {

std::string read(const std::string& text) {
  try {
    return to_text(exact_number(text, 0));
  } catch (const NetFault& fault) {
    return fault.message;
  }
}

}  // namespace

TEST_CASE("Decimals are read exactly", "[net]") {
  CHECK(read("0.1") == "1/10");
  CHECK(read("-0.25") == "-1/4");
  CHECK(read("+3") == "3");
  CHECK(read("010") == "10");
  CHECK(read(".5") == "1/2");
  CHECK(read("5.") == "5");
  CHECK(read("-0") == "0");
  CHECK(read("2.5e-3") == "1/400");
  CHECK(read("1E+2") == "100");
  CHECK(read("0e0005") == "0");
  CHECK(read("9223372036854775807") == "9223372036854775807");
  CHECK(read("-9223372036854775809") == "-9223372036854775809");
  CHECK(read("0.000000000000000001") == "1/1000000000000000000");
  CHECK(read("0.0000000000000000001") == "1/10000000000000000000");
}

TEST_CASE("Fractions are read exactly", "[net]") {
  CHECK(read("1/3") == "1/3");
  CHECK(read("-6/4") == "-3/2");
  CHECK(read("0/7") == "0");
  CHECK(read("1/100000000000000000000") == "1/100000000000000000000");
}

TEST_CASE("Hexadecimal numbers are read exactly", "[net]") {
  CHECK(read("0x1.8p-3") == "3/16");
  CHECK(read("-0X1P+4") == "-16");
  CHECK(read("0xff") == "255");
  CHECK(read("0x.8") == "1/2");
  CHECK(read("0x1.fffffffffffffp+1023").size() == 309);
  // 2^-1074, the smallest number of 64 bits above 0, and 2^1074.
  CHECK(exact_number("0x0.0000000000001p-1022", 0) == power(Rational{2}, -1074));
  CHECK(exact_number("0x1234567890abcdef1p0", 0) == exact_number("20988295476718395121", 0));
}

TEST_CASE("What the C library writes of a number is read back exactly", "[net][law]") {
  std::mt19937_64 random{1};
  for (int k = 0; k < 2000; ++k) {
    // A fraction with a power of 2 below is a number of floating point; %a writes it exactly.
    const auto top = static_cast<std::int64_t>(random() >> 11U) - (std::int64_t{1} << 52);
    const int scale = static_cast<int>(random() % 60);
    char text[64];
    std::snprintf(text, sizeof text, "%a",
                  static_cast<double>(top) / static_cast<double>(std::int64_t{1} << scale));
    CHECK(exact_number(text, 0) == Rational{top} * power(Rational{2}, -scale));
  }
}

TEST_CASE("A decimal is its digits over a power of ten", "[net][law]") {
  std::mt19937_64 random{2};
  for (int k = 0; k < 2000; ++k) {
    std::string digits;
    for (std::size_t count = 1 + random() % 40; digits.size() < count;)
      digits += static_cast<char>('0' + random() % 10);
    const std::size_t behind = random() % (digits.size() + 1);
    const long exponent = static_cast<long>(random() % 41) - 20;
    const Rational whole = *number_from_text(digits);
    std::string text = digits;
    text.insert(digits.size() - behind, ".");
    CHECK(exact_number(text, 0) == whole / power(Rational{10}, static_cast<long>(behind)));
    CHECK(exact_number("-" + text + "e" + std::to_string(exponent), 0) ==
          -whole * power(Rational{10}, exponent - static_cast<long>(behind)));
  }
}

TEST_CASE("What is no finite number is refused", "[net][reject]") {
  const auto expected = [](const std::string& text) {
    return "expected a number, found '" + text + "'";
  };
  for (const std::string text :
       {"",      "-",     "+",     ".",   "e5",  "1e",  "1e+",   "0x",    "0x.p1",
        "0x1p",  "1,5",   "1.2.3", "--1", "1/",  "/2",  "1/-2",  "1/2/3", "1.5/2",
        "1/2.5", "0x1/2", "1e1.5", "x",   "1 2", "0b1", "1_000", "1f"})
    CHECK(read(text) == expected(text));
  CHECK(read("NaN") == "'NaN' is not a point of any patch");
  CHECK(read("-inf") == "'-inf' is not a point of any patch");
  CHECK(read("Infinity") == "'Infinity' is not a point of any patch");
  CHECK(read("1/0") == "a denominator that is 0");
  CHECK(read("1e401") == "an exponent beyond 400");
  CHECK(read("1e-401") == "an exponent beyond 400");
  CHECK(read("1e999999999999999999999") == "an exponent beyond 400");
  CHECK(read("0x1p1201") == "an exponent beyond 1200");
  CHECK(read(std::string(1101, '1')) == "a number with more than 1100 characters");
  CHECK(read(std::string(1100, '1')).size() == 1100);
}
