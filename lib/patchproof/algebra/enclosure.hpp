#pragma once

#include <optional>
#include <string>

#include <patchproof/algebra/number.hpp>

/// Intervals that are certain to contain a real number: the exact way to compare numbers such as
/// sqrt(2) and pi. Source: Moore, Kearfott & Cloud, Introduction to Interval Analysis, ch. 2 and 5.
namespace patchproof {

/// All real numbers from `low` to `high`, both included; low <= high.
struct Enclosure {
  Rational low;
  Rational high;
};

/// The enclosure of one exact number.
Enclosure exactly(const Rational& number);

bool contains(const Enclosure& enclosure, const Rational& number);

/// The exact set of all sums, differences, products, quotients of members.
/// @throws std::domain_error for a divisor that contains zero.
Enclosure operator+(const Enclosure& a, const Enclosure& b);
Enclosure operator-(const Enclosure& a, const Enclosure& b);
Enclosure operator-(const Enclosure& a);
Enclosure operator*(const Enclosure& a, const Enclosure& b);
Enclosure operator/(const Enclosure& a, const Enclosure& b);

/// The exact set of all powers of members, for any whole exponent; x^0 is 1.
/// @throws std::domain_error for a negative power of an enclosure that contains zero.
Enclosure power(const Enclosure& base, long exponent);

/// The least enclosure of `enclosure` whose ends are multiples of 2^-bits: fewer digits to carry.
Enclosure rounded(const Enclosure& enclosure, unsigned bits);

/// The sign all members have: -1, +1, or 0 when zero is the only member; empty when they differ.
std::optional<int> sign(const Enclosure& enclosure);

/// The decimal digits all members share, at most `digits` after the point: "1.41421…".
///
/// Cut off, not rounded; no "…" when the number is exactly what is printed. When members share not
/// even one digit after the point, the ends rounded outward: "[1.999, 2.001]".
std::string to_decimal(const Enclosure& enclosure, unsigned digits);

/// More binary digits than this are refused, and so are arguments of sine and cosine beyond
/// 2^most_bits: they would be slow.
inline constexpr unsigned most_bits = 100'000;

/// The exponential of larger numbers is refused.
inline constexpr int largest_exponent = 10'000;

/// Enclosures of the values of a function at all members of `x`. Each end is less than 2^-bits
/// away from the exact bound and a multiple of about 2^-bits (or exact), so the numbers stay small.
/// @throws std::domain_error for more than `most_bits` bits.
Enclosure pi_enclosure(unsigned bits);

/// Negative members of `x` are left out. Exact for one number that is the square of a fraction.
/// @throws std::domain_error also when all of `x` is negative.
Enclosure square_root(const Enclosure& x, unsigned bits);

/// @throws std::domain_error also for members beyond 2^most_bits.
Enclosure sine(const Enclosure& x, unsigned bits);
Enclosure cosine(const Enclosure& x, unsigned bits);

/// Below -largest_exponent the lower end is 0, and the upper that of -largest_exponent.
/// @throws std::domain_error also for members above `largest_exponent`.
Enclosure exponential(const Enclosure& x, unsigned bits);

}  // namespace patchproof
