#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <patchproof/language/reader.hpp>
#include <patchproof/latex/document.hpp>

namespace patchproof {

/// A case and the file it is in, as the program was told.
using Origin = std::pair<std::string, std::string>;

/// What the .tex file of a case depends on: the text of the case, the definitions it can use, those
/// of the prelude included, language, detail, and the version of this program. 64 hexadecimal
/// digits (SHA-256). None where the source has no such case.
std::optional<std::string> case_digest(const std::shared_ptr<const SourceText>& source,
                                       const std::string& case_name, const Loader& load,
                                       const DocumentOptions& options);

/// The same for a book: it depends on each of its cases.
std::string book_digest(const std::vector<std::string>& digests);

/// The first lines of a .tex file, as comments: version, cases, digest, options.
std::string header_text(const std::vector<Origin>& cases, const std::string& digest,
                        const DocumentOptions& options);

/// What the first lines of a .tex file say.
struct Header {
  std::vector<Origin> cases;
  std::string digest;
  DocumentOptions options;
};

/// None where the file was not written by this program.
std::optional<Header> header_of(const std::string& tex);

}  // namespace patchproof
