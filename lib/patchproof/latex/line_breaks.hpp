#pragma once

#include <string>
#include <vector>

namespace patchproof {

/// About how wide mathematics in LaTeX is set, in hundredths of the type size (em).
///
/// Good enough to tell what surely fits on a line from what may not; TeX itself measures the rest.
int estimated_width(const std::string& latex);

/// The mathematics in pieces between which a line may be broken, put together again the text
/// itself: summands with their signs ("2u", "+ V_{00}"); of a summand wider than half a line the
/// pieces of its brackets too. One piece where there is no such place.
std::vector<std::string> pieces(const std::string& latex);

/// Whether some piece that cannot be broken is so wide that it would be made too small to be read.
bool is_too_wide(const std::string& latex);

/// Mathematics as the macros of the style file want it: as it is where it surely fits on a line,
/// else every piece in a \pps{...}.
std::string breakable(const std::string& latex);

}  // namespace patchproof
