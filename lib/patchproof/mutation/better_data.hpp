#pragma once

#include <vector>

#include <patchproof/mutation/case_mutator.hpp>

namespace patchproof {

/// Whether these data are among those that hide some of the errors.
bool hides(const Data& data, const std::vector<const Mutant*>& hidden);

/// Data with which errors are noticed that those of the case hide: symbols, where the claims hold
/// for these, or one number changed. What notices most comes first; empty when nothing does.
std::vector<BetterData> better_data(const CaseMutator& of,
                                    const std::vector<const Mutant*>& hidden);

}  // namespace patchproof
