#pragma once

#include <string>
#include <vector>

#include <patchproof/certificate/proposition_table.hpp>

namespace patchproof {

/// A part of a proposition as Rocq would write it, cut off with "…" where it gets long.
///
/// `names` are those of the variables bound around it, the outermost first; `depth` is how many there
/// are. A variable without a name is called x7, after its number.
std::string proposition_words(const PropositionTable& table, std::size_t number, std::size_t depth,
                              const std::vector<std::string>& names);

}  // namespace patchproof
