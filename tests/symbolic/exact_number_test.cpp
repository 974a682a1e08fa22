#include <patchproof/symbolic/exact_number.hpp>

#include <catch2/catch.hpp>
#include <random>
#include <stdexcept>
#include <string>

using namespace patchproof;
using namespace patchproof::symbolic;
using GiNaC::numeric;

TEST_CASE("numbers of any length pass between the engines unchanged", "[law]") {
  std::mt19937 random{3};
  for (int round = 0; round < 50; ++round) {
    std::string digits{"1"};
    for (int i = 0; i < round * 20; ++i) digits += static_cast<char>('0' + random() % 10);
    const Integer top{digits};
    const Rational number{round % 2 == 0 ? top : -top, Integer{7}};
    const std::string sign = round % 2 == 0 ? "" : "-";
    const Integer above = numerator(number);
    const Integer below = denominator(number);
    const std::string expected =
        above.str() + (below == 1 ? "" : "/" + below.str());
    CHECK(text(exact(number)) == expected);
  }
  CHECK(text(exact(Rational{-3, 6})) == "-1/2");
  CHECK(text(exact(0)) == "0");
}

TEST_CASE("complex numbers are written with i") {
  const numeric i = GiNaC::ex_to<numeric>(GiNaC::I);
  CHECK(text(i) == "(1*i)");
  CHECK(text(numeric(1, 2) - i * numeric(2, 3)) == "(1/2-2/3*i)");
  CHECK(text(1 + i) == "(1+1*i)");
}

TEST_CASE("a floating-point number is not exact", "[reject]") {
  CHECK_FALSE(is_exact(numeric{0.5}));
  CHECK_THROWS_WITH(text(numeric{0.5}), "not an exact number");
  CHECK_THROWS_WITH(bit_length(numeric{0.5}), "not an exact number");
  CHECK_THROWS_AS(text(numeric{0.5}), std::logic_error);
}

TEST_CASE("the square root of a number is a rational number times square roots of primes",
          "[law]") {
  for (long p = 1; p <= 60; ++p) {
    for (long q = 1; q <= 12; ++q) {
      const SquareRoot root = square_root(numeric(p, q));
      numeric product = root.outside * root.outside;
      for (const Radical& radical : root.inside) {
        CHECK(radical.prime);
        product *= radical.radicand;
      }
      CAPTURE(p, q);
      CHECK(product == numeric(p, q));
    }
  }
}

TEST_CASE("large factors of a radicand that may not be prime are marked") {
  const numeric p{"1000000007"};
  const numeric q{"1000000009"};
  const SquareRoot product = square_root(12 * p * q);
  REQUIRE(product.inside.size() == 2);
  CHECK(product.outside == 2);
  CHECK(product.inside[0].radicand == 3);
  CHECK(product.inside[1].radicand == p * q);
  CHECK_FALSE(product.inside[1].prime);
  CHECK(square_root(p * p).outside == p);
  CHECK(square_root(p).inside.at(0).prime);
}

TEST_CASE("numbers that are not positive have no square root here", "[reject]") {
  CHECK_THROWS_WITH(square_root(numeric{-4}), "the square root of a number that is not positive");
  CHECK_THROWS_AS(square_root(numeric{0}), std::domain_error);
}
