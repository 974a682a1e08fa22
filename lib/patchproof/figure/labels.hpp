#pragma once

#include <functional>
#include <string>

#include <patchproof/term/notation.hpp>

namespace patchproof {

/// From the name of something, "V[0,3]" or "r_uv(0,0)", to LaTeX mathematics without dollar signs.
using LabelText = std::function<std::string(const std::string& name)>;

/// A name in pieces: "V[0,3]" is V with the index 03, "C1" is C with 1, "r_uv(0,1)" is r with uv
/// and behind it (0,1).
struct LabelParts {
  std::string letters;
  std::string index;
  std::string rest;
};
LabelParts label_parts(const std::string& name);

/// V_{03}, C_1, r_{uv}(0,1); what the notation names is written as it says.
LabelText latex_labels(const Notation& notation);

}  // namespace patchproof
