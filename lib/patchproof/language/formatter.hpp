#pragma once

#include <string>

#include <patchproof/term/span.hpp>

namespace patchproof {

/// The text of a case file in its standard form: `patchproof fmt`.
///
/// Lines stay where their author broke them, with at most one blank line between two, and every
/// comment is kept. Statements are indented by two blanks, the parts of an erratum by four, what
/// continues a line by four more than its statement; signs get the blanks the language reference
/// shows. Formatting twice changes nothing more, and the text means what it meant before.
///
/// For a text that has diagnostics the result is unspecified; the caller shows those instead.
std::string formatted(const SourceText& source);

}  // namespace patchproof
