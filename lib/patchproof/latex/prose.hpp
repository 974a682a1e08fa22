#pragma once

#include <string>

namespace patchproof {

/// Text of an author as LaTeX: special characters escaped, "C^2" with a raised digit, "!=", "<="
/// and ">=" as signs.
std::string prose(const std::string& text);

}  // namespace patchproof
