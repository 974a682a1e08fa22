#pragma once

#include <string>

namespace patchproof {

/// What tells this very program from every other one: the build ids that the linker has put into it
/// and into the libraries it runs with, in hexadecimal digits; "" where the program has none.
std::string build_id();

}  // namespace patchproof
