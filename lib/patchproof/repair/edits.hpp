#pragma once

#include <vector>

#include <patchproof/repair/edit.hpp>
#include <patchproof/repair/line.hpp>
#include <patchproof/repair/names.hpp>

namespace patchproof {

/// All single changes of one comparison of a line that are tried, in the order of the text.
///
/// `running` are the running indices of the claim. `determined` are parts whose right value is
/// computed, so that nothing has to be tried in them.
std::vector<Edit> edits_of(const Line& line, const syntax::Comparison& comparison,
                           const Names& names, const std::vector<std::string>& running,
                           const std::vector<Span>& determined);

}  // namespace patchproof
