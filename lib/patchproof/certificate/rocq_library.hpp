#pragma once

#include <string_view>
#include <utility>
#include <vector>

namespace patchproof {

/// The support library of certificates: names and texts of the files of `certificates/`, by name.
/// `ORDER` lists the names of the others without ending, each after those it needs.
const std::vector<std::pair<std::string_view, std::string_view>>& rocq_library_files();

}  // namespace patchproof
