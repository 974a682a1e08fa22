#include <patchproof/grid/modulus.hpp>

namespace patchproof {

Modulus::Modulus(std::uint64_t prime) : prime_{prime}, negative_inverse_{1} {
  // Newton's iteration doubles the number of correct bits of 1/prime modulo 2^64.
  std::uint64_t inverse = prime;
  for (int bits = 3; bits < 64; bits *= 2) inverse *= 2 - prime * inverse;
  negative_inverse_ = 0 - inverse;
  one_ = static_cast<std::uint64_t>((static_cast<Wide>(1) << 64U) % prime);
  factor_ = static_cast<std::uint64_t>(static_cast<Wide>(one_) * one_ % prime);
}

Modulus::Residue Modulus::residue(const Integer& number) const {
  Integer rest = number % prime_;
  if (rest < 0) rest += prime_;
  return product(static_cast<std::uint64_t>(rest), factor_);
}

bool Modulus::has_residue(const Rational& number) const {
  return denominator(number) % prime_ != 0;
}

Modulus::Residue Modulus::residue(const Rational& number) const {
  const Residue above = residue(numerator(number));
  const Integer below = denominator(number);
  // Fermat: x^(prime - 2) is 1/x.
  return below == 1 ? above : product(above, power(residue(below), prime_ - 2));
}

Modulus::Residue Modulus::power(Residue base, std::uint64_t exponent) const {
  Residue result = one_;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) result = product(result, base);
    base = product(base, base);
  }
  return result;
}

namespace {

// 2^61 minus these are prime.
constexpr std::uint64_t distances[] = {1U,   31U,  45U,  229U, 259U, 283U,  339U,  391U,
                                       403U, 465U, 531U, 579U, 675U, 759U,  799U,  819U,
                                       829U, 843U, 859U, 939U, 985U, 1015U, 1153U, 1195U};

}  // namespace

const std::vector<std::uint64_t>& large_primes() {
  static const std::vector<std::uint64_t> primes = [] {
    std::vector<std::uint64_t> result;
    for (const std::uint64_t distance : distances)
      result.push_back((std::uint64_t{1} << 61U) - distance);
    return result;
  }();
  return primes;
}

}  // namespace patchproof
