#pragma once

#include <ginac/ginac.h>

#include <string>

#include <patchproof/symbolic/atoms.hpp>

namespace patchproof::symbolic {

/// The expanded polynomial in plain text, the same in every process: "2*u^2 - 1/3*C1'(0) +
/// V[1,2].x".
///
/// Symbols are ordered by their ordinals, higher powers come first; after 40 summands follows "…".
std::string text(const GiNaC::ex& polynomial, const Atoms& atoms);

}  // namespace patchproof::symbolic
