#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/kernel/hypotheses.hpp>

namespace patchproof {

/// What the kernel finds about the statements of a goal under some of its assumptions.
struct Finding {
  enum class Outcome {
    holds,  ///< every statement holds, wherever the conditions do
    fails,  ///< some equation has a difference that is not identically zero
    open,   ///< an inequality that the kernel could not settle
  };
  Outcome outcome = Outcome::holds;
  std::size_t statement = 0;
  std::size_t component = 0;
  /// left - right there, reduced by the assumptions.
  Fraction residual;
  /// Conditions that the facts do not imply.
  Conditions conditions;
  /// open, for an order: the polynomial that has to be positive, or not negative.
  std::optional<SignFacts::Inequality> asked;
  /// open: what was found out about its sign.
  SignAnswer sign;
  /// The boxes that the inequalities needed.
  Subdivision tree;
};

/// Judges the statements of the goal.
/// @throws NoValue when a condition can never hold; OutsideTheory, FinerAngles, OverBudget
Finding finding(const Goal& goal, Evaluator& evaluator, Hypotheses& hypotheses,
                Workspace& workspace);

/// Adds to `result` the conditions that do not follow from the facts.
void keep_open(const Conditions& conditions, Hypotheses& hypotheses, Workspace& workspace,
               const Span& span, Conditions& result);

}  // namespace patchproof
