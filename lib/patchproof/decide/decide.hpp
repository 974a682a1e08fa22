#pragma once

#include <patchproof/algebra/budget.hpp>
#include <patchproof/decide/decision.hpp>

namespace patchproof {

/// Decides whether the statements of the goal hold: proved, proved_if, refuted with a checked
/// witness, vacuous, unknown, error, or internal when the engines disagree. Never throws for a
/// well-typed goal; work over the limits ends as unknown.
Decision decided(const Goal& goal, const Limits& limits, Engines engines);

/// Solves the equations of the goal for the unknowns and compares with what the solution is said to
/// be.
///
/// `gives` are equations between unknowns and their expected values; they may be none. `leaves` are
/// the unknowns said to stay arbitrary. Proved when exactly those stay free and all of `gives`
/// holds; underdetermined when others are free too; inconsistent when no solution exists; refuted
/// when there is one but not the one given.
Decision solved(const SolveGoal& goal, const std::vector<Statement>& gives,
                const std::vector<SymbolPointer>& leaves, const Limits& limits, Engines engines);

/// Decides whether the candidate has the least value of a functional that is quadratic in the
/// control points of the competitor.
///
/// Proved when the linear part of the difference vanishes and the Hessian is positive semidefinite
/// on the competitors; then `details` tells the size of the Hessian, its pivots, and whether the
/// minimiser is unique. Refuted by a competitor of smaller value. Error when the candidate is none
/// of the competitors.
Decision minimum(const MinimumGoal& goal, const Limits& limits, Engines engines);

}  // namespace patchproof
