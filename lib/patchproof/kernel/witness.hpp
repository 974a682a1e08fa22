#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/kernel/hypotheses.hpp>

namespace patchproof {

/// Values for everything a goal speaks of: numbers, points, explicit polynomials for functions.
struct Witness {
  /// In the order of declaration; one entry for each symbol that is not derived from others.
  std::vector<KnownValue> values;
};

/// What the values have to achieve.
struct WitnessTarget {
  std::vector<Polynomial> not_zero;
  std::vector<SignFacts::Inequality> inequalities;
  /// Values to be tried before all others.
  std::map<Variable, Rational> preferred;
};

/// Looks for a witness: assumptions and ranges are respected, the target polynomials do not
/// vanish; few values differ from zero, and they are small. `attempt` = 0, 1, 2, … varies the order
/// in which values are tried.
///
/// A heuristic: what it returns still has to be checked, see `checked`. Empty when nothing was
/// found.
std::optional<Witness> find_witness(const Goal& goal, const WitnessTarget& target,
                                    Hypotheses& hypotheses, Workspace& workspace, int attempt);

/// What a checked witness shows.
struct WitnessCheck {
  bool consistent = false;  ///< ranges and assumptions hold at the witness
  bool refutes = false;     ///< some statement is false there
  std::size_t statement = 0;
  std::size_t component = 0;
  std::string left;   ///< exact values of both sides at that component
  std::string right;
  std::string why_not;  ///< when not consistent: what fails or could not be shown
};

/// Puts the witness into the statements, from the terms on, and evaluates both sides exactly (or by
/// certified enclosures that exclude equality).
WitnessCheck checked(const Goal& goal, const Witness& witness, Budget& budget);

}  // namespace patchproof
