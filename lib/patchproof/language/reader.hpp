#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <patchproof/claims/claim.hpp>
#include <patchproof/language/diagnostic.hpp>
#include <patchproof/language/library.hpp>

namespace patchproof {

/// What a file holds: its cases, ready to be decided, and what is wrong with it. A case with
/// mistakes is left out.
struct ReadFile {
  std::vector<Case> cases;
  std::vector<Diagnostic> diagnostics;
};

/// The text of an included file, by its path as seen from the current directory; empty when it
/// cannot be read. The reader itself touches no files.
using Loader = std::function<std::optional<std::string>(const std::string& path)>;

/// Reads a text: includes, definitions, cases.
ReadFile read_cases(std::shared_ptr<const SourceText> source, const Limits& limits,
                    const Loader& load);

/// The definitions of one text and of what it includes, on top of the prelude; for
/// `patchproof definitions`.
Library read_definitions(const std::shared_ptr<const SourceText>& source, const Loader& load,
                         std::vector<Diagnostic>& diagnostics);

}  // namespace patchproof
