#include <patchproof/algebra/number.hpp>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace patchproof {

namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

// Digits are added by hand: the Boost constructor reads a leading zero as octal. Nine at a time,
// so that the longest number costs a thousand multiplications, not ten thousand.
Integer append_digits(Integer value, std::string_view digits) {
  while (!digits.empty()) {
    const std::string_view chunk = digits.substr(0, 9);
    digits.remove_prefix(chunk.size());
    std::uint32_t scale = 1;
    std::uint32_t part = 0;
    for (const char digit : chunk) {
      scale *= 10;
      part = part * 10 + static_cast<std::uint32_t>(digit - '0');
    }
    value = value * scale + part;
  }
  return value;
}

std::size_t bit_length(const Integer& magnitude) {
  return magnitude == 0 ? 0 : boost::multiprecision::msb(magnitude) + 1;
}

}  // namespace

std::optional<Rational> number_from_text(std::string_view text) {
  if (text.size() > longest_number) return std::nullopt;
  const std::size_t point = text.find('.');
  const std::string_view whole = text.substr(0, point);
  if (!all_digits(whole)) return std::nullopt;
  if (point == std::string_view::npos) return Rational{append_digits(0, whole)};
  const std::string_view fraction = text.substr(point + 1);
  if (!all_digits(fraction)) return std::nullopt;
  const Integer numerator = append_digits(append_digits(0, whole), fraction);
  const Integer denominator =
      boost::multiprecision::pow(Integer{10}, static_cast<unsigned>(fraction.size()));
  return Rational{numerator, denominator};
}

std::string to_text(const Rational& number) {
  const Integer bottom = denominator(number);
  std::string text = numerator(number).str();
  if (bottom != 1) text += "/" + bottom.str();
  return text;
}

std::size_t bit_length(const Rational& number) {
  if (number.is_small()) {
    const auto [top, bottom] = number.words();
    return static_cast<std::size_t>(
        top == 0 ? 0 : std::bit_width(static_cast<std::uint64_t>(std::max(std::abs(top), bottom))));
  }
  const Integer top = boost::multiprecision::abs(numerator(number));
  return std::max(bit_length(top), bit_length(denominator(number)));
}

Rational power(const Rational& base, long exponent) {
  if (exponent < 0 && base == 0) throw std::domain_error{"a negative power of zero"};
  // Squaring of numerator and denominator apart: a power of a fraction in lowest terms is in
  // lowest terms, so nothing has to be cancelled on the way.
  Integer above = numerator(base);
  Integer below = denominator(base);
  Integer top = 1;
  Integer bottom = 1;
  unsigned long rest = exponent < 0 ? 0UL - static_cast<unsigned long>(exponent)
                                    : static_cast<unsigned long>(exponent);
  while (rest != 0) {
    if ((rest & 1U) != 0) {
      top *= above;
      bottom *= below;
    }
    rest >>= 1U;
    if (rest != 0) {
      above *= above;
      below *= below;
    }
  }
  if (exponent < 0) {
    std::swap(top, bottom);
    if (bottom < 0) {
      top = -top;
      bottom = -bottom;
    }
  }
  // Boost looks for a common divisor even of a whole number and 1, in quadratic time.
  if (bottom == 1) return top;
  return Rational{top, bottom};
}

}  // namespace patchproof
