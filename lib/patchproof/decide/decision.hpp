#pragma once

#include <string>
#include <utility>
#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/algebra/sign_over_box.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof {

/// The answer to a claim.
enum class Verdict {
  proved,           ///< holds for everything the statement speaks of
  proved_if,        ///< holds where the listed conditions hold
  refuted,          ///< false at the witness
  vacuous,          ///< the assumptions contradict each other: nothing was shown
  underdetermined,  ///< derive: there are several solutions
  inconsistent,     ///< derive: there is no solution
  unknown,          ///< not decided, for the reason given
  error,            ///< the statement has no value: division by zero and the like
  internal,         ///< the two engines disagree: a fault of this program
};

/// "PROVED", "PROVED IF", "REFUTED", …
std::string to_text(Verdict verdict);

/// How well a verdict is founded.
enum class Evidence {
  none,          ///< no verdict
  kernel,        ///< decided by the kernel; the second engine gave no opinion
  both_engines,  ///< decided by the kernel, and the second engine agrees
  certified,  ///< and a certificate was accepted by a proof assistant, see `Decision::certificate`
};
std::string to_text(Evidence evidence);

/// Exact values at which a statement is false, in words.
struct WitnessReport {
  /// "u" -> "1/2", "C1(u)" -> "1 - u"; in the order of declaration, zeros included.
  std::vector<std::pair<std::string, std::string>> values;
  /// The same values as terms.
  std::vector<KnownValue> assignment;
  std::string left;
  std::string right;
  /// Which component of the two sides: "", "x", "[1,2].x".
  std::string component;
};

/// What the engines found out about one goal.
struct Decision {
  Verdict verdict = Verdict::unknown;
  Evidence evidence = Evidence::none;
  /// Certified: by what, "coqc 8.16.1, axioms: …"; else "".
  std::string certificate;
  /// Unknown, error, internal: why. Inconsistent: the equation that cannot hold. Refuted: what is
  /// known beyond the witness, where an inequality is nowhere false but for its strictness.
  std::string reason;
  /// Error: where.
  Span span;
  /// Proved if: "a - b != 0", in a fixed order.
  std::vector<std::string> conditions;
  /// Refuted: left - right at the first differing component, after all assumptions.
  std::string residual;
  WitnessReport witness;
  /// Index of the statement of the goal that is false.
  std::size_t statement = 0;
  /// Labels of assumptions without which the proof does not go through, in order.
  std::vector<std::string> assumptions_used;
  /// Proved: the boxes on which inequalities were decided; none where other facts were enough.
  Subdivision subdivision;
  /// Derive: the solution for each unknown that has one, in words and as values.
  std::vector<std::pair<std::string, std::string>> derived;
  std::vector<KnownValue> solution;
  /// Derive: unknowns that stay arbitrary.
  std::vector<std::string> free;
  /// Minimum: what the answer rests on, such as "Hessian" -> "4 x 4, positive definite".
  std::vector<std::pair<std::string, std::string>> details;
};

/// Which engines to ask.
enum class Engines {
  usual,   ///< the kernel, and the second engine for as long as it is cheap
  both,    ///< the second engine for as long as the limits allow
  kernel,  ///< no second opinion
};

/// What a second opinion may cost. None is wanted when `engines` is `kernel`.
Limits limits_of_second_opinion(const Limits& limits, Engines engines);

}  // namespace patchproof
