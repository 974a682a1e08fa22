#pragma once

#include <string>

#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// The syntax tree as JSON, two blanks per level, ending in a line end.
///
/// Every node is an object with "kind", "line" and "column", then what it holds, in the order of
/// the text and under the names of `syntax`; what is not written is left out. Numbers are texts
/// ("1/10"), so that nothing is rounded. Texts that are not valid UTF-8 get U+FFFD for the wrong
/// bytes.
std::string dump(const syntax::File& file);

}  // namespace patchproof
