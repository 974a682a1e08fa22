#pragma once

#include <string>

#include <patchproof/kernel/hypotheses.hpp>
#include <patchproof/kernel/witness.hpp>

namespace patchproof {

/// How many times numbers are looked for before the search is given up.
constexpr int most_attempts = 8;

/// Asks of the values to be found that they satisfy the conditions.
void add(const Conditions& conditions, WitnessTarget& target);

/// Why no values are known that satisfy all assumptions of the goal and the conditions; "" when
/// there are some. Without that a proof may be about nothing at all.
std::string inconsistency(const Goal& goal, const Conditions& conditions, Hypotheses& hypotheses,
                          Workspace& workspace);

}  // namespace patchproof
