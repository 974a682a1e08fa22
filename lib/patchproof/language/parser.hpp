#pragma once

#include <memory>
#include <vector>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// What was read of a file; with diagnostics, `file` holds what could be made of the rest.
struct Parsed {
  syntax::File file;
  std::vector<Diagnostic> diagnostics;
};

/// Parses a whole text. Never throws for any text whatever; never recurses deeper than
/// `deepest_nesting`.
Parsed parse(std::shared_ptr<const SourceText> source);

/// How deeply parentheses, brackets and exponents may nest.
inline constexpr int deepest_nesting = 200;

}  // namespace patchproof
