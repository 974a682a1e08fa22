#pragma once

#include <memory>
#include <string>
#include <vector>

#include <patchproof/language/parser.hpp>
#include <patchproof/language/reader.hpp>
#include <patchproof/repair/repair.hpp>

namespace patchproof {

/// The repairs of all false statements of a text with one case and no definitions; none for a text
/// with mistakes.
inline std::vector<Repairs> repairs_in(const std::string& text, const RepairOptions& options = {}) {
  const auto source = std::make_shared<const SourceText>(SourceText{"a.proof", text});
  const ReadFile file =
      read_cases(source, Limits{}, [](const std::string&) { return std::optional<std::string>{}; });
  if (!file.diagnostics.empty() || file.cases.size() != 1) return {};
  return repairs_of(parse(source).file.cases.front(), file.cases.front(), Library::prelude(),
                    options);
}

/// The same for the statements of a case; the statement that is false comes last.
inline Repairs repairs_in_case(const std::string& statements, const RepairOptions& options = {}) {
  const std::vector<Repairs> all = repairs_in("case a\n" + statements + "end\n", options);
  return all.empty() ? Repairs{} : all.back();
}

/// The repaired statements.
inline std::vector<std::string> texts(const Repairs& repairs) {
  std::vector<std::string> result;
  for (const Repair& repair : repairs.repairs) result.push_back(repair.text);
  return result;
}

}  // namespace patchproof
