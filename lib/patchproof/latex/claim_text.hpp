#pragma once

#include <string>

#include <patchproof/derivation/case_derivation.hpp>
#include <patchproof/latex/mathematics.hpp>

namespace patchproof {

/// The statement of a claim as written: relations one below the other; unknowns, conditions and the
/// stated solution of a derivation; candidate and competitors of a minimum.
std::string statement_text(const Claim& claim, const Wording& wording);

/// What the names of a case stand for, without further words.
std::string definitions_text(const CheckedDerivation& derivation, const Wording& wording);

/// The passages of a derivation, each with the words it begins with.
std::string passages_text(const CheckedDerivation& derivation, const Wording& wording);

/// A claim with heading, statement, derivation and verdict. A claim that corrects the erratum right
/// before it has no heading of its own. The remark stands behind the statement.
std::string claim_text(const ClaimResult& result, const ClaimDerivation& derivation,
                       bool goes_on_with_erratum, const Wording& wording,
                       const std::string& remark = "");

/// "south" for the two parts of an erratum, "south.printed" and "south.corrected"; else the label.
std::string common_label(const Claim& claim);

}  // namespace patchproof
