#pragma once

#include <map>
#include <optional>

#include <patchproof/algebra/enclosure.hpp>
#include <patchproof/kernel/atoms.hpp>

namespace patchproof {

/// An interval that certainly contains the value of a fraction where its variables, also those in
/// the arguments of elementary functions, have these values. Empty when the precision is too low to
/// divide.
/// @throws OutsideTheory when it contains an unknown, or an integral that was not worked out.
std::optional<Enclosure> enclosure_at(const Fraction& fraction,
                                      const std::map<Variable, Rational>& at, const Atoms& atoms,
                                      unsigned bits, Budget& budget);

}  // namespace patchproof
