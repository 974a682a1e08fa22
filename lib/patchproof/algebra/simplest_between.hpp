#pragma once

#include <optional>

#include <patchproof/algebra/number.hpp>

namespace patchproof {

/// The simplest fraction between the ends; an end that is empty is infinite, a strict one left out.
///
/// Zero when it is inside, else the whole number nearest to zero, else the fraction of smallest
/// denominator (and then nearest to zero). Empty when the interval has no members.
/// Source: Graham, Knuth & Patashnik, Concrete Mathematics, 4.5 (Stern-Brocot tree).
std::optional<Rational> simplest_between(const std::optional<Rational>& low, bool low_strict,
                                         const std::optional<Rational>& high, bool high_strict);

}  // namespace patchproof
