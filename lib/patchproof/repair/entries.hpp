#pragma once

#include <vector>

#include <patchproof/claims/claim.hpp>
#include <patchproof/repair/edit.hpp>
#include <patchproof/repair/line.hpp>

namespace patchproof {

/// What is known of the numerals that stand as entries of a literal tuple or matrix, where the
/// comparison is with something that has a value.
struct Entries {
  /// All of them.
  std::vector<Span> determined;
  /// Those that differ from the value, with the right one: put in, they make the entries agree.
  /// Empty when something else differs as well.
  std::vector<Edit> corrections;
};

/// Looks at the entries of a line with one comparison; `claim` is what the line claims.
Entries entries_of(const Line& line, const Claim& claim, const Limits& limits);

}  // namespace patchproof
