#pragma once

#include <string>

#include <patchproof/term/span.hpp>

namespace patchproof {

/// "coons.proof:18:3"; "" without a text.
std::string place_of(const Span& span);

/// The lines a span runs over, numbered as in the messages about mistakes; a span within one line
/// has carets below it. Long statements and long lines are cut off.
std::string excerpt_of(const Span& span);

/// The text itself; "" without a source.
std::string as_written(const Span& span);

}  // namespace patchproof
