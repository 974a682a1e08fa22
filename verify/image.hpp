#pragma once

#include <string>

#include <verify/files.hpp>

namespace patchproof {

/// The SVG document as PNG at 300 dots per inch, by the program rsvg-convert; or what went wrong,
/// with a line of help where there is some.
FileText png_of(const std::string& svg);

}  // namespace patchproof
