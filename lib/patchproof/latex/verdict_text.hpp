#pragma once

#include <string>

#include <patchproof/claims/verification.hpp>
#include <patchproof/latex/mathematics.hpp>

namespace patchproof {

/// What makes a refuted claim false: the witness and both sides there, and the difference of the
/// sides; the witness is left out where the derivation shows one.
std::string refutation_text(const Decision& decision, bool with_witness, const Wording& wording);

/// Verdict and evidence in plain sight, with conditions, reasons, and what else belongs to them.
///
/// What is not decided, has no meaning, or is not what the author expects stands in a frame.
std::string verdict_text(const ClaimResult& result, const Wording& wording);

}  // namespace patchproof
