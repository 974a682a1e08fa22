#pragma once

#include <patchproof/term/term.hpp>

namespace patchproof {

/// The term with its numbers worked out as a person would: 1-0 is 1, summands and factors that are
/// zero go, factors 1 go, products of written-out matrices are multiplied out, B_i^n at 0 and 1 is a
/// number. Sums keep their order and are not expanded.
///
/// Only a proposal for a step of a derivation, which the engines decide.
Term tidied(const Term& term);

}  // namespace patchproof
