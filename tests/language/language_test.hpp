#pragma once

#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include <patchproof/language/dump.hpp>
#include <patchproof/language/formatter.hpp>
#include <patchproof/language/parser.hpp>

namespace patchproof {

/// The text as if read from the file bad.proof.
inline std::shared_ptr<const SourceText> source_of(std::string text) {
  return std::make_shared<const SourceText>(SourceText{"bad.proof", std::move(text)});
}

/// All that is shown of the mistakes in a text; "" when there are none.
inline std::string messages_of(std::string text) {
  std::string result;
  for (const Diagnostic& diagnostic : parse(source_of(std::move(text))).diagnostics) {
    result += to_text(diagnostic);
  }
  return result;
}

/// The syntax tree without positions, as lines.
inline std::string meaning_of(const syntax::File& file) {
  // Texts in JSON hold no line ends, so a position is always a line of its own.
  std::istringstream tree(dump(file));
  std::string result;
  for (std::string line; std::getline(tree, line);) {
    const std::string_view entry = std::string_view(line).substr(line.find_first_not_of(' '));
    const bool is_position =
        entry.rfind("\"line\": ", 0) == 0 || entry.rfind("\"column\": ", 0) == 0;
    if (!is_position) result += std::string(entry) + "\n";
  }
  return result;
}

inline std::string meaning_of(const std::string& text) {
  return meaning_of(parse(source_of(text)).file);
}

}  // namespace patchproof
