#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <patchproof/term/term.hpp>

namespace patchproof {

/// What a sum in one Bernstein basis has before each basis function.
struct BasisRows {
  /// The basis functions B_0, B_1, … as terms, in order, those that occur.
  std::vector<Term> basis;
  /// The coefficient of each, a sum of the parts in the order they stand there.
  std::vector<Term> coefficients;
};

/// The coefficients of 3 B_0(u) V[0,1] - 3 B_0(u) V[0,0] + …; empty unless each summand has exactly
/// one basis function, all of one degree and one argument.
///
/// Two such sums are equal exactly when their coefficients are: the B_i are linearly independent.
std::optional<BasisRows> basis_rows(const Term& value);

}  // namespace patchproof
