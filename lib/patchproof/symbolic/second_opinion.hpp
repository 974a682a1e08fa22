#pragma once

#include <string>
#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof {

/// What the second engine (GiNaC and CLN) says of a goal.
struct SecondOpinion {
  enum class Answer {
    holds,  ///< the differences of all sides are zero modulo the assumptions
    fails,  ///< some difference is not zero: its normal form is not, in a complete theory
    none,   ///< over budget, or outside what this engine decides
  };
  Answer answer = Answer::none;
  /// Why there is no answer.
  std::string reason;
  /// The first difference that is not zero, in a fixed order and notation; "" otherwise.
  std::string normal_form;
};

/// Decides, from the term tree on and without the kernel, whether the equations of the goal hold
/// generically (denominators taken as non-zero).
SecondOpinion second_opinion(const Goal& goal, const Limits& limits);

/// Checks a solved system: `solution` satisfies all equations identically, and apart from the
/// unknowns in `free` (which stay arbitrary) there is no other one.
SecondOpinion second_opinion_on_solution(const SolveGoal& goal,
                                         const std::vector<KnownValue>& solution,
                                         const std::vector<SymbolPointer>& free,
                                         const Limits& limits);

}  // namespace patchproof
