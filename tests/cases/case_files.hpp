#pragma once

#include <string>
#include <vector>

#include <patchproof/language/loader.hpp>
#include <patchproof/term/span.hpp>

namespace patchproof::test {

/// The sanitizers make everything many times slower, and only have to see the code run: tests that
/// decide all cases then look at a part of them.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// The files below cases/, by path, as the program reads them; only those whose path contains
/// `part`.
std::vector<SourceText> case_files(const std::string& part = "");

/// Reads the files that cases take nets from.
Loader case_loader();

/// All files below cases/; under sanitizers every sixth of them.
std::vector<SourceText> sampled_case_files();

}  // namespace patchproof::test
