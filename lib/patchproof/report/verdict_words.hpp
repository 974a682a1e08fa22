#pragma once

#include <string>

#include <patchproof/claims/verification.hpp>

namespace patchproof {

/// The verdict with what belongs to it, in one line: "PROVED", "PROVED IF a - b != 0",
/// "UNKNOWN: limit: …", "UNDERDETERMINED: free V[1,1]"; cut off where it gets long.
std::string verdict_line(const Decision& decision);

/// The verdict an author expects: "PROVED", "REFUTED", "UNKNOWN" or "INCONSISTENT".
std::string expected_verdict(Expectation expectation);

/// The values of a witness, those that are not zero first:
/// "u = 1/2, C1(u) = 1 - u; all others 0".
std::string in_words(const WitnessReport& witness);

/// "Bernstein subdivision: 7 boxes, depth 4"; "" where no boxes were needed.
std::string in_words(const Subdivision& tree);

}  // namespace patchproof
