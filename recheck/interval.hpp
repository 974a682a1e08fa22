#pragma once

#include <recheck/field.hpp>

namespace recheck {

/// All numbers from lower to upper.
struct Interval {
  Rational lower;
  Rational upper;
};

/// Numbers between which atoms certainly lie.
using Box = std::map<Atom, Interval>;

/// An interval that certainly contains all values over the box; empty when some atom is neither a
/// root nor in the box, or when a divisor may vanish. Roots are enclosed to `digits` binary digits.
std::optional<Interval> enclosure(const Quotient& a, const Box& box, unsigned digits, Field& field);

/// The sign of a number: -1, 0 or 1; empty when the quotient contains more than numbers and roots.
/// @throws Unsupported when many digits do not tell
std::optional<int> sign(const Quotient& a, Field& field);

/// Whether a is shown not to be negative anywhere in the box, by its enclosure.
bool is_nonnegative(const Quotient& a, const Box& box, Field& field);

/// Whether the enclosure shows a sign without zero everywhere in the box.
bool is_nonzero(const Quotient& a, const Box& box, Field& field);

/// Whether a is shown to be negative everywhere in the box, by its enclosure.
bool is_negative(const Quotient& a, const Box& box, Field& field);

}  // namespace recheck
