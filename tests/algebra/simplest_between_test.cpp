#include <patchproof/algebra/simplest_between.hpp>

#include <catch2/catch.hpp>
#include <random>

using patchproof::Rational;
using patchproof::simplest_between;

namespace {

int small(std::mt19937& random, int largest) {
  return static_cast<int>(random() % (2 * static_cast<unsigned>(largest) + 1)) - largest;
}

}  // namespace

TEST_CASE("the simplest number of an interval") {
  const Rational third{1, 3};
  CHECK(simplest_between({}, false, {}, false) == Rational{0});
  CHECK(simplest_between(Rational{-1}, false, third, false) == Rational{0});
  CHECK(simplest_between(Rational{0}, true, {}, false) == Rational{1});
  CHECK(simplest_between({}, false, Rational{0}, true) == Rational{-1});
  CHECK(simplest_between(Rational{0}, false, Rational{0}, false) == Rational{0});
  CHECK(simplest_between(Rational{3}, true, {}, true) == Rational{4});
  CHECK(simplest_between(Rational(7, 2), false, Rational{9}, true) == Rational{4});
  CHECK(simplest_between({}, false, Rational(-7, 2), true) == Rational{-4});
  CHECK(simplest_between(Rational{0}, true, Rational{1}, true) == Rational(1, 2));
  CHECK(simplest_between(Rational{0}, true, Rational(1, 2), true) == third);
  CHECK(simplest_between(Rational{-1}, true, Rational{0}, true) == Rational(-1, 2));
  CHECK(simplest_between(third, false, third, false) == third);
  CHECK(simplest_between(Rational(314, 100), true, Rational(315, 100), true) == Rational(22, 7));
  CHECK(simplest_between(Rational{2}, true, Rational(22, 10), true) == Rational(13, 6));
}

TEST_CASE("an interval without members has no simplest number", "[reject]") {
  CHECK_FALSE(simplest_between(Rational{1}, false, Rational{0}, false));
  CHECK_FALSE(simplest_between(Rational{1}, true, Rational{1}, false));
  CHECK_FALSE(simplest_between(Rational{0}, false, Rational{0}, true));
}

TEST_CASE("no fraction of smaller denominator lies between the ends", "[law]") {
  std::mt19937 random{14};
  for (int i = 0; i < 300; ++i) {
    const Rational low{small(random, 200), 1 + static_cast<int>(random() % 60)};
    const Rational high = low + Rational(1, 1 + random() % 90);
    const bool low_strict = random() % 2 == 0;
    const bool high_strict = random() % 2 == 0;
    INFO(low << ".." << high << " strict " << low_strict << high_strict);
    const auto inside = [&](const Rational& x) {
      return (low < x || (low == x && !low_strict)) && (x < high || (x == high && !high_strict));
    };
    const std::optional<Rational> simplest = simplest_between(low, low_strict, high, high_strict);
    REQUIRE(simplest);
    CHECK(inside(*simplest));
    for (int q = 1; q < denominator(*simplest); ++q) {
      const Rational scaled = low * q;
      const patchproof::Integer near = numerator(scaled) / denominator(scaled);
      for (int offset = -1; offset <= 3; ++offset) {
        CHECK_FALSE(inside(Rational{near + offset, q}));
      }
    }
  }
}

TEST_CASE("the simplest number between ends of thousands of digits is found at once") {
  const Rational huge = patchproof::power(Rational(1'000'003, 999'983), 500);
  const Rational low = huge - patchproof::power(10, -3000);
  const std::optional<Rational> simplest = simplest_between(low, true, huge, true);
  REQUIRE(simplest);
  CHECK(*simplest > low);
  CHECK(*simplest < huge);
}
