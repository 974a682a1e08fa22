#pragma once

#include <ginac/ginac.h>

#include <cstddef>
#include <string>
#include <vector>

#include <patchproof/algebra/number.hpp>

namespace patchproof::symbolic {

/// The number, made from the decimal text of its numerator and denominator.
GiNaC::numeric exact(const Rational& number);

/// Whether the number is p/q or p/q + r/s*i; no floating-point number is.
bool is_exact(const GiNaC::numeric& number);

/// How many binary digits the longest of the whole numbers in p/q + r/s*i has.
std::size_t bit_length(const GiNaC::numeric& number);

/// "p", "p/q", or "(p/q+r/s*i)".
/// @throws std::logic_error unless the number is exact.
std::string text(const GiNaC::numeric& number);

/// A square root of a whole number that is left standing.
struct Radical {
  GiNaC::numeric radicand;
  /// Square roots of different primes are linearly independent; of other numbers perhaps not.
  bool prime = false;
};

/// sqrt(number) == outside * product of the square roots of `inside`.
struct SquareRoot {
  GiNaC::numeric outside = 1;
  std::vector<Radical> inside;
};

/// The square root of an exact positive number; only small prime factors are looked for.
/// @throws std::domain_error unless the number is real and positive.
SquareRoot square_root(const GiNaC::numeric& number);

}  // namespace patchproof::symbolic
