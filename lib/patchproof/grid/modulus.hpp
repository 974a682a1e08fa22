#pragma once

#include <cstdint>
#include <vector>

#include <patchproof/algebra/number.hpp>

namespace patchproof {

/// The field of the residues modulo a prime below 2^61, in Montgomery form: x stands for
/// x * 2^64 modulo the prime. Source: Montgomery, Modular multiplication without trial division,
/// Math. Comp. 44 (1985).
class Modulus {
 public:
  using Residue = std::uint64_t;

  /// For an odd prime below 2^61.
  explicit Modulus(std::uint64_t prime);

  std::uint64_t prime() const { return prime_; }
  Residue residue(const Integer& number) const;
  /// Whether the denominator is not a multiple of the prime; then the number has a residue.
  bool has_residue(const Rational& number) const;
  Residue residue(const Rational& number) const;

  Residue sum(Residue a, Residue b) const {
    const Residue result = a + b;
    return result >= prime_ ? result - prime_ : result;
  }
  Residue difference(Residue a, Residue b) const { return a >= b ? a - b : a + prime_ - b; }
  Residue product(Residue a, Residue b) const { return reduced(static_cast<Wide>(a) * b); }

 private:
  __extension__ using Wide = unsigned __int128;

  // x / 2^64 for x < 2^64 * prime.
  Residue reduced(Wide x) const {
    const std::uint64_t factor = static_cast<std::uint64_t>(x) * negative_inverse_;
    const auto result = static_cast<std::uint64_t>((x + static_cast<Wide>(factor) * prime_) >> 64U);
    return result >= prime_ ? result - prime_ : result;
  }
  Residue power(Residue base, std::uint64_t exponent) const;

  std::uint64_t prime_;
  /// -1/prime modulo 2^64.
  std::uint64_t negative_inverse_;
  /// 2^64 and 2^128 modulo the prime: 1 and 2^64 in Montgomery form.
  std::uint64_t one_;
  std::uint64_t factor_;
};

/// Some primes just below 2^61, the largest first.
const std::vector<std::uint64_t>& large_primes();

}  // namespace patchproof
