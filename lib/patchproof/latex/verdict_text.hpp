#pragma once

#include <string>

#include <patchproof/claims/verification.hpp>
#include <patchproof/latex/mathematics.hpp>

namespace patchproof {

/// What of a refutation is still to be said; the rest is in the derivation.
struct RefutationParts {
  bool values = true;      ///< of the witness
  bool sides = true;       ///< both sides at the witness
  bool difference = true;  ///< of the sides
};

/// What makes a refuted claim false: the witness and both sides there, and their difference.
std::string refutation_text(const Decision& decision, const RefutationParts& parts,
                            const Wording& wording);

/// Verdict and evidence in plain sight, with conditions, reasons, and what else belongs to them.
///
/// What is not decided, has no meaning, or is not what the author expects stands in a frame.
std::string verdict_text(const ClaimResult& result, const Wording& wording);

}  // namespace patchproof
