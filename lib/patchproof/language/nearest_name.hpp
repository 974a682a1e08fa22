#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace patchproof {

/// The known name that differs least from `word`, for "did you mean"; "" when none is near.
///
/// A name is near when at most a third of the letters of `word` (but always one, and never all)
/// would have to be inserted, removed, changed or swapped with their neighbour. Of equally near
/// names the first one counts.
/// Source: optimal string alignment distance (Damerau, 1964).
std::string nearest_name(std::string_view word, const std::vector<std::string>& known);

/// "did you mean 'prove'?", or "" when no known name is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace patchproof
