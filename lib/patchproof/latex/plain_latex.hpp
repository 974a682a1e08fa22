#pragma once

#include <string>

#include <patchproof/term/notation.hpp>

namespace patchproof {

/// Mathematics in the words of a report ("-2*V[0,0] + 1/3*P_u(0,0)", "a - b != 0") as LaTeX
/// mathematics.
///
/// Names go by the notation, juxtaposition is multiplication, fractions of numbers are upright. For
/// texts written by this program; of any other text, what it cannot read stays as it is, escaped.
std::string plain_latex(const std::string& text, const Notation& notation);

}  // namespace patchproof
