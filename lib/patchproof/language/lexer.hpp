#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include <patchproof/language/diagnostic.hpp>

namespace patchproof {

/// One word, number, text or sign of a source text: bytes [begin, end).
struct Token {
  enum class Kind : std::uint8_t {
    name,
    number,
    text,     ///< "...", with its quotes
    sign,     ///< an operator or a bracket
    comment,  ///< from # to the end of the line, without trailing blanks
    bad,      ///< already reported; the parser says nothing more about it
    end,      ///< the end of the source text
  };
  Kind kind = Kind::end;
  bool first_on_line = false;
  std::uint32_t line = 1;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The tokens of a source text.
struct Lexed {
  std::vector<Token> tokens;    ///< without comments; the last one is of kind `end`
  std::vector<Token> comments;  ///< in the order of the text
  std::vector<Diagnostic> diagnostics;
  /// False for a binary file and for more than `most_tokens`: there is nothing to parse then.
  bool readable = true;
};

/// How many tokens a text may have; beyond that a parser would only fill the memory.
inline constexpr std::size_t most_tokens = 3'000'000;

/// The tokens of a whole text, in time linear in its length.
Lexed tokens_of(const std::shared_ptr<const SourceText>& source);

}  // namespace patchproof
