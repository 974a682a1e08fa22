// Fuzz target of the language front: whatever the text, parsing ends well; whatever the text
// without mistakes, formatting keeps its meaning and is done after once.

#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>

#include <patchproof/language/dump.hpp>
#include <patchproof/language/formatter.hpp>
#include <patchproof/language/parser.hpp>
#include <tests/fuzz/law.hpp>

namespace {

using namespace patchproof;
using fuzz::violated;

/// The syntax tree without positions, as lines.
std::string meaning_of(const syntax::File& file) {
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto source = std::make_shared<const SourceText>(
      SourceText{"fuzz.proof", std::string(reinterpret_cast<const char*>(data), size)});
  const Parsed parsed = parse(source);
  if (!parsed.diagnostics.empty()) {
    if (parsed.diagnostics.size() > 20) violated("at most 20 diagnostics", source->text);
    for (const Diagnostic& diagnostic : parsed.diagnostics) to_text(diagnostic);
    dump(parsed.file);
    return 0;
  }
  const auto once =
      std::make_shared<const SourceText>(SourceText{"fuzz.proof", formatted(*source)});
  const Parsed again = parse(once);
  if (!again.diagnostics.empty()) violated("a formatted text has no mistakes", once->text);
  if (meaning_of(again.file) != meaning_of(parsed.file)) violated("same meaning", once->text);
  if (formatted(*once) != once->text) violated("formatting is done after once", once->text);
  return 0;
}
