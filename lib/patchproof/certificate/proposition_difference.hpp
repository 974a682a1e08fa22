#pragma once

#include <string>
#include <vector>

#include <patchproof/certificate/proposition_table.hpp>

namespace patchproof {

/// Where two propositions first differ, in words:
/// "premise 2: Rocq understood 0 where 1 was asked, in C1 0 = D1 0". "" when they are the same. What
/// differs in which variables or premises there are stands behind premise 0, 1, ….
///
/// `names` are those of the variables, the outermost first; others get names of their own.
std::string proposition_difference(const PropositionTable& table, std::size_t understood,
                                   std::size_t asked, const std::vector<std::string>& names);

}  // namespace patchproof
