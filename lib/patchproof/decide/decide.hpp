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

}  // namespace patchproof
