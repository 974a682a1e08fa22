#pragma once

#include <string>
#include <vector>

namespace patchproof {

/// Writes an SVG document as PNG, by the program rsvg-convert, at 300 dots per inch. A file that is
/// one of the inputs is left as it is. @returns "" or what went wrong.
std::string write_png(const std::string& svg, const std::string& path,
                      const std::vector<std::string>& inputs);

}  // namespace patchproof
