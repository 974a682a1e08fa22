#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <verify/selection.hpp>

namespace patchproof {

/// The claims selected, undecided: each with its id and what its author expects; as aligned lines,
/// or for the format "json" as a document {"version", "claims": [...]}.
std::string list_of(const std::vector<const Case*>& cases, const Selection& selection,
                    std::string_view format);

}  // namespace patchproof
