#pragma once

#include <optional>
#include <string>
#include <vector>

namespace patchproof {

/// The name of an entry of an array: "V[1,2]" is V and 1, 2.
struct ArrayEntry {
  std::string array;
  std::vector<unsigned> indices;
};

/// The name taken apart; nothing when it is no entry of an array, or has an index of more than four
/// digits.
std::optional<ArrayEntry> array_entry(const std::string& name);

}  // namespace patchproof
