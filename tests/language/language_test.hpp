#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

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

inline void remove_positions(nlohmann::ordered_json& node) {
  if (node.is_object()) {
    node.erase("line");
    node.erase("column");
  }
  if (node.is_structured()) {
    for (auto& part : node) remove_positions(part);
  }
}

/// The syntax tree of a text without mistakes, as JSON without positions.
inline std::string meaning_of(const std::string& text) {
  auto tree = nlohmann::ordered_json::parse(dump(parse(source_of(text)).file));
  remove_positions(tree);
  return tree.dump(1);
}

}  // namespace patchproof
