#pragma once

#include <patchproof/derivation/computation.hpp>

namespace patchproof {

/// The derivation of a claim as proposed, by its kind and verdict.
///
/// An equation that holds: its left side worked out until the right side is reached, or both until
/// they are the same. One that does not: both sides at the witness, and their difference.
/// `known` are the values that derivations used by the claim have found.
Derivation claim_derivation(const ClaimResult& result, const std::vector<KnownValue>& known,
                            Computation& computation);

/// Unknowns from equations: both sides worked out, the conditions compared, the solution, and the
/// solution put into the conditions.
std::vector<Passage> solution_passages(const DeriveClaim& claim, const Decision& decision,
                                       const std::vector<KnownValue>& known,
                                       Computation& computation);

/// Minimality: the values of the functional at a competitor and at the candidate differ by its value
/// at their difference, which is not negative.
std::vector<Passage> minimum_passages(const MinimumClaim& claim,
                                      const std::vector<KnownValue>& known,
                                      Computation& computation);

/// Both sides of the statement worked out until they meet; before that, of a derivative of higher
/// order the lower ones. `reason` is why the last link holds where it is no mere calculation.
std::vector<Chain> equation_chains(const Statement& statement, const Reason& reason,
                                   Computation& computation);

}  // namespace patchproof
