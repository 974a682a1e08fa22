#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <patchproof/algebra/rational.hpp>

namespace patchproof {

/// The most digits a number may have in a case file; longer text is rejected, not read slowly.
inline constexpr std::size_t longest_number = 10'000;

/// The exact number written as decimal text: digits, optionally followed by a point and digits.
///
/// "0.1" is 1/10 and "010" is ten. Empty for anything else, and for more than `longest_number`
/// characters; the Boost constructors are not used because they read "010" as octal.
std::optional<Rational> number_from_text(std::string_view text);

/// The number as "p" or "p/q".
std::string to_text(const Rational& number);

/// How many binary digits the larger of numerator and denominator has; 0 for zero.
std::size_t bit_length(const Rational& number);

/// base^exponent for any whole exponent.
/// @throws std::domain_error for a negative power of zero.
Rational power(const Rational& base, long exponent);

}  // namespace patchproof
