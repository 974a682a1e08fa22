#pragma once

#include <string>
#include <vector>

#include <patchproof/language/reader.hpp>

namespace patchproof::test {

/// One small change of the text of a true claim: a sign, a number, an index.
struct Mutation {
  std::string claim;  ///< id of the claim that was changed
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string replacement;
  /// "cases/a.proof: sk.x.y: '… u + [v] …' -> '-'": where and what, for people and for the list of
  /// survivors.
  std::string description;
};

/// All mutations of the true claims (prove, derive, the corrected half of an erratum) of a file:
/// + and - exchanged, whole numbers raised by one, the last digit of names exchanged (C1, C2).
std::vector<Mutation> mutations(const SourceText& source);

/// Whether the run notices: the text is rejected, or the verdict of some instance of the claim is
/// not as expected.
bool is_caught(const SourceText& source, const Mutation& mutation);

/// Each case of a file as a text of its own, so that checking one change reads one case only. The
/// files of cases/ have no definitions of their own.
std::vector<SourceText> single_cases(const SourceText& file);

/// The files below cases/, by path, as the program reads them.
std::vector<SourceText> case_files();

}  // namespace patchproof::test
