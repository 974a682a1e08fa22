#pragma once

#include <vector>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/claims/verification.hpp>

namespace patchproof {

/// What has to be shown for the verdict of a claim, with the derived values it uses put in.
///
/// One sequent for most claims. A solved derivation has two: the equations give the values, and the
/// values satisfy the equations.
std::vector<Sequent> sequents_of(const ClaimResult& claim);

/// The parameters in the terms, in the order of their ordinals: those a statement speaks of for all
/// their values.
std::vector<SymbolPointer> parameters_of(const Statement& statement);

/// How many scalars the two sides of the statement have.
std::size_t component_count(const Statement& statement);

}  // namespace patchproof
