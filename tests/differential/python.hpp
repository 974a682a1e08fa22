#pragma once

#include <string>

namespace patchproof::differential {

/// A python3 that has SymPy: the first on the path, or that of Debian.
/// @throws std::runtime_error when there is none
std::string python_with_sympy();

}  // namespace patchproof::differential
