#pragma once

#include <optional>
#include <string>

#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// A statement in one line, and its syntax tree.
struct Line {
  std::string text;
  syntax::Proposition proposition;

  /// Where a part of the statement stands in `text`.
  static std::size_t begin_of(const Span& span);
  static std::size_t end_of(const Span& span);
  /// The part as written.
  std::string text_of(const Span& span) const;
};

/// Reads a statement; empty when it is none.
std::optional<Line> line_of(const std::string& text);

/// What was written there, without comments and in one line.
std::string in_one_line(const Span& span);

}  // namespace patchproof
