#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace patchproof {

/// The textbook definitions that come with the library: the name ("coons.proof") and the text of
/// each file of lib/patchproof/prelude, in the order of the names.
///
/// The texts are byte for byte those of the files and part of the library, so a program needs no
/// files beside it. They live as long as the program.
const std::vector<std::pair<std::string_view, std::string_view>>& prelude_files();

}  // namespace patchproof
