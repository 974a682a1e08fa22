#pragma once

#include <string>

#include <patchproof/figure/figure.hpp>
#include <patchproof/figure/labels.hpp>

namespace patchproof {

/// The figure as a tikzpicture: one command for each shape, in millimetres with two digits.
/// Needs the package tikz and nothing of its libraries.
std::string tikz(const Figure& figure, const LabelText& label_text);

}  // namespace patchproof
