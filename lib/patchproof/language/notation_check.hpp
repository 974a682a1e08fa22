#pragma once

#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// Whether a text is LaTeX that only writes a symbol: letters, digits, signs, scripts and the
/// commands of a fixed list (Greek letters, alphabets, accents).
///
/// Commands that read files, define, or write are not on the list, so a case can bring no TeX
/// program into a document. @throws Fault at the place inside the text.
void check_notation(const syntax::Notation& notation);

}  // namespace patchproof
