#pragma once

#include <string>

namespace patchproof {

/// "# text", indented, with a mark on each of its lines.
std::string python_comment(const std::string& text, const std::string& indentation);

/// Code of Python with its long lines broken at spaces inside brackets; where there are none, a value
/// that is assigned or returned gets some. A remark at the end of a long line goes before it.
std::string python_lines(const std::string& code);

}  // namespace patchproof
