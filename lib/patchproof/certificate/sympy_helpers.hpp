#pragma once

#include <string_view>

namespace patchproof {

/// What stands at the top of a script of SymPy: unknown functions, derivatives, integrals, Bernstein
/// polynomials, and how expressions are compared with zero.
std::string_view sympy_helpers();

}  // namespace patchproof
