#pragma once

#include <string>

#include <patchproof/term/term.hpp>

namespace patchproof {

/// The term as one would write it in a case file, with no more parentheses than it needs.
///
/// Longer text is cut off after `longest` bytes (never inside a character) and ends in "…"; the
/// time is that of the text written, although a term with shared parts may stand for a text of
/// any length. A function is written as its body; an empty term as nothing.
std::string to_text(const Term& term, std::size_t longest = 400);

}  // namespace patchproof
