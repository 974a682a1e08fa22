#pragma once

#include <optional>

#include <patchproof/algebra/enclosure.hpp>
#include <patchproof/kernel/atoms.hpp>

namespace patchproof {

/// An interval that certainly contains the value of a fraction without unknowns: numbers, pi and
/// elementary functions of such. Empty when an unknown occurs or the precision is too low to divide.
std::optional<Enclosure> enclosure(const Fraction& fraction, const Atoms& atoms, unsigned bits,
                                   Budget& budget);

/// The sign of such a fraction: exact for rational numbers, otherwise by enclosures of growing
/// precision. Empty when unknowns occur, or zero could not be excluded.
std::optional<int> certain_sign(const Fraction& fraction, const Atoms& atoms, Budget& budget);

}  // namespace patchproof
