#pragma once

#include <string>

#include <patchproof/term/notation.hpp>

namespace patchproof {

/// A name as it is typeset: its letters, and its lower index if it has one.
struct LatexName {
  std::string letters;  ///< "C", "\\alpha", "\\mathit{rCD}", "\\mathbf r"
  std::string index;    ///< "1", "C", "01"; empty for none

  /// Letters and index together: "C_{1}".
  std::string text() const;
};

/// The name of a symbol, perhaps an entry of an array: "C1", "V[0,2]", "M_R[1,1]", "alpha".
///
/// What the notation says of the name before the brackets goes before what its spelling suggests:
/// digits at the end and what follows an underscore are an index, names of Greek letters are those
/// letters, several letters are one name.
LatexName latex_name(const std::string& name, const Notation& notation);

/// Text outside of mathematics, with TeX's special characters escaped.
std::string latex_escaped(const std::string& text);

}  // namespace patchproof
