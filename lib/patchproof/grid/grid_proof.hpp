#pragma once

#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/grid/tape.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof {

/// Whether the equations of the goal hold identically: true is a proof. False says nothing.
///
/// For goals without assumptions whose sides are polynomials in few parameters (and scalars), of
/// degree at most one in everything else. The differences are evaluated at the points of a grid,
/// modulo primes: a polynomial that is zero at all points of a grid that is larger than its degree
/// is zero modulo the prime, and whole coefficients that are smaller than the product of the primes
/// are zero then. docs/trust.md has the lemma with its proof.
/// @throws OverBudget
bool holds_on_grid(const Goal& goal, Budget& budget);

/// The same for steps of a tape with so many variables: whether all are zero identically.
bool are_zero(const Tape& tape, const std::vector<Tape::Step>& steps, Budget& budget);

}  // namespace patchproof
