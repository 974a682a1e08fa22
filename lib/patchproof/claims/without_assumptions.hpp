#pragma once

#include <set>
#include <string>
#include <vector>

#include <patchproof/claims/claim.hpp>

namespace patchproof {

/// What an assumption is called: its label, or "assumption 3" by its place among all.
std::string assumption_name(const std::string& label, std::size_t index);

/// The names of the assumptions above a claim, in order, each once.
std::vector<std::string> assumption_names(const Claim& claim);

/// The names of those that speak of what the claim speaks of, directly or by way of others or of
/// the derivations it uses.
///
/// A parameter they share does not count: it stands for all of its values in each of them. An
/// inequality restricts the parameters it names, so there it does.
std::set<std::string> related_assumptions(const Case& given, const Claim& claim);

/// The kernel's decision on a claim of the case without the assumptions of these names. What it
/// uses of derivations is derived with all assumptions.
Decision decided_without(const Case& given, const Claim& claim, const std::set<std::string>& names);

}  // namespace patchproof
