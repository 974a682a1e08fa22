#include <numeric>

#include <patchproof/net/common_denominator.hpp>

namespace patchproof {

std::optional<Integer> common_denominator(const std::vector<Rational>& numbers,
                                          std::size_t most_bits) {
  // While it is a word, which it is mostly, no large number is made.
  std::int64_t word = 1;
  Integer large = 0;
  for (const Rational& number : numbers) {
    if (large == 0 && number.is_small()) {
      const std::int64_t other = number.words().denominator;
      if (word % other == 0) continue;
      std::int64_t product = 0;
      if (!__builtin_mul_overflow(word, other / std::gcd(word, other), &product)) {
        word = product;
        continue;
      }
    }
    if (large == 0) large = word;
    const Integer other = denominator(number);
    if (large % other == 0) continue;
    large = boost::multiprecision::lcm(large, other);
    if (boost::multiprecision::msb(large) >= most_bits) return std::nullopt;
  }
  if (large == 0) large = word;
  if (boost::multiprecision::msb(large) >= most_bits) return std::nullopt;
  return large;
}

}  // namespace patchproof
