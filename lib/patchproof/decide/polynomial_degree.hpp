#pragma once

#include <optional>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/term/term.hpp>

namespace patchproof {

/// The degree of a function in its k-th parameter, where all its components are polynomials in it
/// whose coefficients do not depend on it; empty otherwise, and when that costs more than the
/// limits.
std::optional<unsigned> polynomial_degree(const Term& function, std::size_t parameter,
                                          const Limits& limits);

}  // namespace patchproof
