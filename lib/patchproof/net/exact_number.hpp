#pragma once

#include <string_view>

#include <patchproof/algebra/rational.hpp>

namespace patchproof {

/// The most characters a number in a file of points may have: as many as the longest exact decimal
/// of a number of 64 bits with floating point, -0. and 1074 digits, and some more.
inline constexpr std::size_t longest_coordinate = 1100;

/// The largest decimal exponent, with either sign: 1e400 is read, 1e401 is not. Numbers of 64 bits
/// with floating point have exponents from -324 to 308.
inline constexpr int largest_decimal_exponent = 400;

/// The largest binary exponent of a hexadecimal number, with either sign. Numbers of 64 bits with
/// floating point have exponents from -1074 to 1023.
inline constexpr int largest_binary_exponent = 1200;

/// The exact value of a coordinate: a whole number, a decimal "-0.1" or "2.5e-3", a fraction of
/// whole numbers "1/3", or a hexadecimal number with floating point as of C ("0x1.8p-3" is 3/16;
/// the exponent is binary, and may be missing). Nothing is rounded: "0.1" is 1/10.
///
/// `at` is where the token stands in its text.
/// @throws NetFault for anything else, for NaN and infinity, a denominator 0, and for more
/// characters or larger exponents than above.
Rational exact_number(std::string_view token, std::size_t at);

}  // namespace patchproof
