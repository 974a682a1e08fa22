#pragma once

#include <string>

namespace patchproof {

/// The text with its long lines broken, so that a reader can read it: at relations, + and - first,
/// outside of as many brackets as can be; what follows is indented the more the deeper it stands. A
/// line has at most 100 characters where it has a place to break. Only spaces become line breaks, so
/// it says the same.
std::string with_short_lines(const std::string& text);

}  // namespace patchproof
