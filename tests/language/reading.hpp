#pragma once

#include <map>
#include <memory>
#include <string>

#include <patchproof/language/reader.hpp>

namespace patchproof {

/// All that is shown of the mistakes in a file bad.proof with this text, types included; "" when
/// there are none. `files` are the texts that can be included.
inline std::string reading_messages(const std::string& text,
                                    const std::map<std::string, std::string>& files = {}) {
  const auto source = std::make_shared<const SourceText>(SourceText{"bad.proof", text});
  const Loader load = [&](const std::string& path) -> std::optional<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) return std::nullopt;
    return found->second;
  };
  std::string result;
  for (const Diagnostic& diagnostic : read_cases(source, Limits{}, load).diagnostics)
    result += to_text(diagnostic);
  return result;
}

/// The same for statements of one case, on line 2 and below.
inline std::string type_messages(const std::string& statements) {
  return reading_messages("case a\n" + statements + "end\n");
}

}  // namespace patchproof
