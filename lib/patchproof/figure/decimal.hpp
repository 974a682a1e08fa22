#pragma once

#include <string>

#include <patchproof/algebra/number.hpp>

namespace patchproof {

/// The number with so many digits after the point, at most half a unit of the last digit away from
/// it (a half goes away from zero); zeros at the end are left out, and there is no "-0".
std::string decimal(const Rational& number, unsigned digits);

/// The nearest multiple of 2^-bits; a half goes up.
Rational rounded(const Rational& number, unsigned bits);

}  // namespace patchproof
