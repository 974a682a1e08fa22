#pragma once

#include <map>
#include <string>

#include <patchproof/report/record.hpp>

namespace patchproof {

/// How often what happened in a run.
struct Summary {
  std::size_t cases = 0;
  std::size_t claims = 0;
  /// Every outcome with the number of claims it is the outcome of, zeros left out.
  std::map<Outcome, std::size_t> outcomes;
  /// The same for the verdicts of the claims decided as expected.
  std::map<Verdict, std::size_t> expected_verdicts;
  /// Claims proved as expected, but under conditions.
  std::size_t conditional = 0;
  /// Mistakes in the texts.
  std::size_t mistakes = 0;
  std::size_t unreadable_files = 0;
  /// Cases with assumptions that nothing needs, where that was asked.
  std::size_t flagged = 0;
  /// Terms to show and audits that were lost with whoever worked on them.
  std::size_t lost = 0;
};

/// Adds what happened in one more file.
void add(const FileRecord& file, Summary& summary);

/// One word for JSON: "as_expected", "wrong", …
std::string to_text(Outcome outcome);

/// "412 claims in 57 cases: 405 as expected (300 proved, 105 refuted), 6 wrong, 1 unknown"
std::string in_words(const Summary& summary);

}  // namespace patchproof
