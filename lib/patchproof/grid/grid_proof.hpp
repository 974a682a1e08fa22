#pragma once

#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/grid/tape.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof {

/// What the values on a grid show of a goal.
struct GridAnswer {
  enum class Kind {
    unknown,
    holds,   ///< proved
    differs  ///< false at these values
  };
  Kind kind = Kind::unknown;
  /// For `differs`: numbers and points for every free symbol that is not known.
  std::vector<KnownValue> values = {};
};

/// Whether the equations of the goal hold identically.
///
/// For goals without assumptions whose sides are polynomials in few parameters (and scalars), of
/// degree at most one in everything else. The differences are evaluated at the points of a grid,
/// modulo primes: a polynomial that is zero at all points of a grid that is larger than its degree
/// is zero modulo the prime, and whole coefficients that are smaller than the product of the primes
/// are zero then. docs/trust.md has the lemma with its proof. Where a difference is not zero modulo
/// a prime, it is not zero.
/// @throws OverBudget
GridAnswer answer_on_grid(const Goal& goal, Budget& budget);

/// Whether the grid shows that the goal holds.
/// @throws OverBudget
bool holds_on_grid(const Goal& goal, Budget& budget);

}  // namespace patchproof
