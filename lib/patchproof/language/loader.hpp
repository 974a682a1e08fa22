#pragma once

#include <functional>
#include <optional>
#include <string>

namespace patchproof {

/// The text of a file that another one names, by its path as seen from the current directory; empty
/// when it cannot be read. The reader itself touches no files.
using Loader = std::function<std::optional<std::string>(const std::string& path)>;

/// A path as written in a file, as seen from where that file is: "definitions.proof" in
/// "cases/a.proof" is "cases/definitions.proof".
std::string path_beside(const std::string& file, const std::string& path);

}  // namespace patchproof
