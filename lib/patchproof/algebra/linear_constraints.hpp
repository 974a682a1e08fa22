#pragma once

#include <map>
#include <optional>
#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/algebra/number.hpp>
#include <patchproof/algebra/simplest_between.hpp>

namespace patchproof {

/// sum of coefficients[x] * x, plus constant, is zero, at least zero, or above zero.
struct LinearConstraint {
  enum class Kind { zero, at_least_zero, above_zero };

  /// By the number of the variable; a variable that is not listed has coefficient 0.
  std::map<unsigned, Rational> coefficients;
  Rational constant;
  Kind kind = Kind::zero;
};

/// Values that satisfy all constraints, or nothing when the constraints contradict each other.
///
/// Every variable listed in a constraint gets a value, in ascending order of their numbers, each
/// the simplest (see `simplest_between`) that the earlier ones leave open.
/// @throws OverBudget; the number of constraints grows fast with the number of variables.
/// Source: Schrijver, Theory of Linear and Integer Programming, 12.2 (Fourier-Motzkin elimination).
std::optional<std::map<unsigned, Rational>> small_model(
    const std::vector<LinearConstraint>& constraints, Budget& budget);

}  // namespace patchproof
