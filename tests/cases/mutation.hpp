#pragma once

#include <string>
#include <vector>

#include <patchproof/language/reader.hpp>
#include <tests/cases/case_files.hpp>

namespace patchproof::test {

/// One small change of the text of a case: a sign, a number, an index, a hypothesis left out.
struct Mutation {
  /// Id of the claim that was changed; "" when a hypothesis or a value was, so that every claim of
  /// the case may notice.
  std::string claim;
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string replacement;
  /// "cases/a.proof: sk.x.y: '… u + [v] …' -> '-'": where and what, for people and for the list of
  /// survivors.
  std::string description;
};

/// All mutations of the true claims (prove, derive, the corrected half of an erratum), of the
/// hypotheses and of the declared values of a file: + and - exchanged, whole numbers raised by one,
/// the last digit of names exchanged (C1, C2), a hypothesis replaced by 0 == 0.
std::vector<Mutation> mutations(const SourceText& source);

/// Whether the run notices: the text is rejected, or the verdict of some instance of the claim is
/// not as expected.
bool is_caught(const SourceText& source, const Mutation& mutation);

/// Each case of a file as a text of its own, so that checking one change reads one case only. The
/// files of cases/ have no definitions of their own.
std::vector<SourceText> single_cases(const SourceText& file);

}  // namespace patchproof::test
