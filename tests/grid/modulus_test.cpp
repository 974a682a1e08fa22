#include <catch2/catch.hpp>
#include <random>
#include <set>

#include <patchproof/grid/modulus.hpp>

namespace patchproof {

namespace {

Integer random_integer(std::mt19937_64& random, int words) {
  Integer result = 0;
  for (int k = 0; k < words; ++k) result = (result << 64) + random();
  return random() % 2 == 0 ? result : -result;
}

Integer remainder(const Integer& number, std::uint64_t prime) {
  const Integer rest = number % prime;
  return rest < 0 ? rest + prime : rest;
}

}  // namespace

TEST_CASE("the primes are prime, different and below 2^61") {
  std::set<std::uint64_t> seen;
  for (const std::uint64_t prime : large_primes()) {
    CHECK(prime < (std::uint64_t{1} << 61U));
    CHECK(prime > (std::uint64_t{1} << 60U));
    CHECK(seen.insert(prime).second);
    // The first twelve primes are enough as bases below 3.3 * 10^24. Source: Sorenson & Webster,
    // Strong pseudoprimes to twelve prime bases, Math. Comp. 86 (2017).
    std::uint64_t odd = prime - 1;
    int twos = 0;
    for (; odd % 2 == 0; odd /= 2) ++twos;
    for (const int base : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37}) {
      Integer power = boost::multiprecision::powm(Integer{base}, Integer{odd}, Integer{prime});
      bool witness = power != 1 && power != prime - 1;
      for (int k = 1; witness && k < twos; ++k) {
        power = power * power % prime;
        if (power == prime - 1) witness = false;
      }
      CHECK(!witness);
    }
  }
  CHECK(seen.size() >= 20);
}

TEST_CASE("residues are calculated with as numbers are", "[law]") {
  std::mt19937_64 random{61};
  for (const std::uint64_t prime : large_primes()) {
    const Modulus modulus{prime};
    for (int round = 0; round < 200; ++round) {
      const Integer a = random_integer(random, 1 + round % 4);
      const Integer b = round % 5 == 0 ? Integer{prime} * (round % 7) + round % 3 - 1
                                       : random_integer(random, 1 + round % 3);
      const auto x = modulus.residue(a);
      const auto y = modulus.residue(b);
      CHECK(modulus.sum(x, y) == modulus.residue(Integer{a + b}));
      CHECK(modulus.difference(x, y) == modulus.residue(Integer{a - b}));
      CHECK(modulus.product(x, y) == modulus.residue(Integer{a * b}));
      CHECK((x == y) == (remainder(a - b, prime) == 0));
    }
  }
}

TEST_CASE("a fraction has the residue that its denominator makes that of its numerator", "[law]") {
  std::mt19937_64 random{62};
  const std::uint64_t prime = large_primes().front();
  const Modulus modulus{prime};
  for (int round = 0; round < 200; ++round) {
    const Integer above = random_integer(random, 1 + round % 3);
    const Integer below = random_integer(random, 1 + round % 2) * 2 + 1;
    const Rational number{above, below};
    if (!modulus.has_residue(number)) continue;
    CHECK(modulus.product(modulus.residue(number), modulus.residue(below)) ==
          modulus.residue(above));
  }
  CHECK(!modulus.has_residue(Rational{Integer{1}, Integer{prime}}));
  CHECK(!modulus.has_residue(Rational{Integer{5}, Integer{prime} * 6}));
  CHECK(modulus.has_residue(Rational{Integer{prime}, Integer{7}}));
}

}  // namespace patchproof
