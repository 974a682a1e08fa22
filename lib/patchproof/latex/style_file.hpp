#pragma once

#include <string_view>

namespace patchproof {

/// The name of the style file that all documents use: "patchproof.sty".
inline constexpr std::string_view style_file_name = "patchproof.sty";

/// The text of the style file. For LuaLaTeX; the same for all documents and languages.
///
/// Chains of equations are set by its own macros: the left side is measured, rows are filled with
/// summands up to the width of the line, and what is too wide all the same is made smaller, so that
/// no row runs into the margin.
std::string_view style_file();

}  // namespace patchproof
