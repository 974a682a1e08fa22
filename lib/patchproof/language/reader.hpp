#pragma once

#include <memory>
#include <vector>

#include <patchproof/claims/claim.hpp>
#include <patchproof/language/diagnostic.hpp>
#include <patchproof/language/library.hpp>
#include <patchproof/language/loader.hpp>

namespace patchproof {

/// What a file holds: its cases, ready to be decided, and what is wrong with it. A case with
/// mistakes is left out.
struct ReadFile {
  std::vector<Case> cases;
  std::vector<Diagnostic> diagnostics;
};

/// Reads a text: includes, definitions, files of nets, cases.
ReadFile read_cases(std::shared_ptr<const SourceText> source, const Limits& limits,
                    const Loader& load);

/// The definitions of one text and of what it includes, on top of the prelude, and the files its
/// cases take nets from; for `patchproof definitions`, and for whoever reads single claims.
Library read_definitions(const std::shared_ptr<const SourceText>& source, const Loader& load,
                         std::vector<Diagnostic>& diagnostics);

}  // namespace patchproof
