#pragma once

#include <string>
#include <vector>

#include <patchproof/term/span.hpp>

namespace patchproof {

/// Something is wrong with the text of a case: where, what, and what to do about it.
struct Diagnostic {
  Span span;
  std::string message;
  /// What to do; "" when the message says it all.
  std::string help;
};

/// Line and column of a byte, both from 1; columns count characters, not bytes.
struct Position {
  std::size_t line = 1;
  std::size_t column = 1;
};
Position position_of(const SourceText& source, std::size_t byte);

/// The message as shown to a person:
///
///     bad.proof:3:24: error: expected an operator before 'u'
///          3 |   curve C(u) = (u, 0, 4u(1-u))
///            |                        ^
///            = help: multiplication is written '*'
///
/// Long lines are cut to a window around the caret; control characters and invalid bytes are
/// shown as U+FFFD, so that a report is always valid UTF-8.
std::string to_text(const Diagnostic& diagnostic);

/// The diagnostics in the order of their places, at most one per place, at most `most` of them.
std::vector<Diagnostic> in_order(std::vector<Diagnostic> diagnostics, std::size_t most = 20);

}  // namespace patchproof
