#pragma once

#include <string>

#include <patchproof/figure/figure.hpp>

namespace patchproof {

/// The figure as an SVG document of its own, one element for each shape, in millimetres with
/// two digits and a margin for labels. Labels are text in italics with small lowered indices.
std::string svg(const Figure& figure);

}  // namespace patchproof
