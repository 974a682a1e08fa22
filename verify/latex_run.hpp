#pragma once

#include <chrono>
#include <string>

namespace patchproof {

/// How a run of LaTeX ended.
struct LatexRun {
  /// There is a PDF.
  bool good = false;
  /// What is missing or went wrong, for a person; "" when all is well.
  std::string problem;
};

/// Makes the PDF of a .tex file in a folder by latexmk and LuaLaTeX: without a shell, without
/// commands from TeX, and not longer than the time given.
LatexRun pdf_of(const std::string& folder, const std::string& tex, std::chrono::seconds longest);

/// The first error in the log of LaTeX run with -file-line-error: file, line and message.
struct LatexError {
  std::string file;
  std::size_t line = 0;
  std::string message;
};
LatexError first_error(const std::string& log);

/// The place in a case that a line of a .tex file was written for, "coons.proof:12"; "" where there
/// is none.
std::string place_in_case(const std::string& tex, std::size_t line);

}  // namespace patchproof
