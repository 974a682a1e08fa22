#pragma once

#include <string>
#include <vector>

#include <patchproof/derivation/case_derivation.hpp>
#include <patchproof/latex/words.hpp>

namespace patchproof {

/// How documents are written.
struct DocumentOptions {
  Language language = Language::english;
  Detail detail = Detail::steps;
  /// Bodies only, to be read by \input into a document that uses the style file.
  bool fragment = false;
  /// With a picture of each case that has something to be drawn.
  bool figures = true;
};

/// A case with all that its page shows.
struct Page {
  CaseResult result;
  CaseDerivation derivation;
  /// As `case_figure` says; "" for none.
  std::string figure;
  /// What the page depends on, as `case_digest` says.
  std::string digest;
};

/// The name of the file of a case: "coons.to_bezier.tex".
std::string file_name(const Case& given);

/// The name of the file that holds all cases: "book.tex".
inline constexpr const char* book_name = "book.tex";

/// The .tex file of a case: a document of its own, which a book can read with \input all the same;
/// or, as a fragment, its body alone.
///
/// Before each claim stands a comment with its place in the case: "% case coons.proof:12".
std::string document(const Page& page, const DocumentOptions& options);

/// The first lines of a document: class, language, style file.
std::string preamble(const std::string& document_class, Language language);

/// The .tex file of a book over cases: title, contents, a chapter for each folder of cases, a
/// chapter of all errata, a table of verdicts. It reads the files of the cases.
std::string book(const std::vector<Page>& pages, const DocumentOptions& options);

}  // namespace patchproof
