#pragma once

#include <cstdint>

#include <patchproof/algebra/rational.hpp>

namespace patchproof {

/// A whole number of 128 bits, which both supported compilers have.
__extension__ using DoubleWord = __int128;

/// A whole fraction as a number of the type; it has to fit.
template <typename Number>
Number strip_number(const Rational& value);

template <>
inline Rational strip_number<Rational>(const Rational& value) {
  return value;
}

template <>
inline std::int64_t strip_number<std::int64_t>(const Rational& value) {
  return value.is_small() ? value.words().numerator : numerator(value).convert_to<std::int64_t>();
}

template <>
inline DoubleWord strip_number<DoubleWord>(const Rational& value) {
  if (value.is_small()) return value.words().numerator;
  const Integer whole = numerator(value);
  const Integer magnitude = boost::multiprecision::abs(whole);
  const auto high = static_cast<DoubleWord>((magnitude >> 64U).convert_to<std::uint64_t>());
  const auto low =
      static_cast<DoubleWord>((magnitude & 0xFFFF'FFFF'FFFF'FFFFU).convert_to<std::uint64_t>());
  const DoubleWord result = high * (DoubleWord{1} << 64U) + low;
  return whole.sign() < 0 ? -result : result;
}

inline Rational to_rational(const Rational& value) { return value; }
inline Rational to_rational(std::int64_t value) { return Rational{value}; }
inline Rational to_rational(DoubleWord value) {
  const DoubleWord magnitude = value < 0 ? -value : value;
  const Integer high{static_cast<std::uint64_t>(magnitude >> 64U)};
  const Rational result{Integer{(high << 64U) + Integer{static_cast<std::uint64_t>(magnitude)}}};
  return value < 0 ? -result : result;
}

}  // namespace patchproof
