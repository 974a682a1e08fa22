#pragma once

#include <string>
#include <utility>
#include <vector>

#include <patchproof/kernel/witness.hpp>

namespace patchproof {

/// The values in words: "u" -> "1/2", "V[0,0]" -> "(1, 0, 0)", "C1(u)" -> "u - u^2".
///
/// A point of any dimension is shown by its value in dimension one.
std::vector<std::pair<std::string, std::string>> in_words(const Witness& witness);

}  // namespace patchproof
