#pragma once

#include <string>

#include <patchproof/claims/verification.hpp>
#include <patchproof/latex/mathematics.hpp>

namespace patchproof {

/// The title in the language, where the case has one, else its own title, else its name; in running
/// text.
std::string title_text(const Case& given, Language language);

/// What a case takes as given: points, numbers, curves of some smoothness, parameters with their
/// ranges; of a family of cases what its first instance has. "" where nothing is given.
std::string given_text(const Case& given, const Wording& wording);

/// The assumptions of a case with their labels and the notes of the author; "" without any.
std::string assumptions_text(const Case& given, const Wording& wording);

/// Which assumptions of the case the claim does not have, as it stands above them; "" for none.
std::string later_assumptions_text(const Case& given, const Claim& claim, const Wording& wording);

/// The goal of a claim of any kind.
const Goal& goal_of(const Claim& claim);

}  // namespace patchproof
