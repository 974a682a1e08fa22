#include <patchproof/repair/search.hpp>

#include <patchproof/repair/canonical.hpp>
#include <patchproof/repair/edits.hpp>
#include <patchproof/repair/entries.hpp>

namespace patchproof {

void SearchBudget::spend() {
  if (spent_ >= most_) throw SearchStopped{};
  if (timed_ && std::chrono::steady_clock::now() > end_) throw SearchStopped{};
  ++spent_;
}

ComparisonSearch::ComparisonSearch(const Line& line, CandidateJudge& judge, const Names& names,
                                   const Limits& limits, std::size_t most_changes,
                                   SearchBudget& budget)
    : line_{line},
      judge_{judge},
      names_{names},
      limits_{limits},
      most_changes_{most_changes},
      budget_{budget} {}

std::vector<std::vector<Edit>> ComparisonSearch::least() {
  try {
    search();
  } catch (const SearchStopped&) {
    if (found_.empty()) throw;
    stopped_ = true;
  }
  return found_;
}

void ComparisonSearch::search() {
  const syntax::Comparison& comparison = line_.proposition.comparisons.front();
  seen_.insert(canonical(comparison, names_));
  Entries entries;
  const std::vector<Claim> claims = judge_.first_claims(line_.proposition);
  if (!claims.empty()) entries = entries_of(line_, claims.front(), limits_);
  all_ = edits_of(line_, comparison, names_, judge_.running(), entries.determined);
  const std::size_t corrections = entries.corrections.size();
  for (std::size_t count = 1; count <= most_changes_ && found_.empty(); ++count) {
    if (corrections == count) try_edits(entries.corrections);
    std::vector<Edit> chosen;
    combine(count, 0, chosen);
  }
  if (found_.empty() && corrections > most_changes_) try_edits(entries.corrections);
}

void ComparisonSearch::combine(std::size_t count, std::size_t from, std::vector<Edit>& chosen) {
  if (count == 0) return try_edits(chosen);
  for (std::size_t k = from; k < all_.size(); ++k) {
    if (!chosen.empty() && overlap(chosen.back(), all_[k])) continue;
    chosen.push_back(all_[k]);
    combine(count - 1, k + 1, chosen);
    chosen.pop_back();
  }
}

void ComparisonSearch::try_edits(const std::vector<Edit>& edits) {
  budget_.spend();
  const std::optional<Line> line = line_of(changed(line_.text, edits));
  if (!line || line->proposition.comparisons.size() != 1) return;
  const syntax::Comparison& comparison = line->proposition.comparisons.front();
  // 0*(…) == 0 and a == a are true, but nobody has meant them.
  if (is_trivial(comparison, names_)) return;
  if (!seen_.insert(canonical(comparison, names_)).second) return;
  if (!judge_.may_hold(line->proposition)) return;
  const Verdict verdict = judge_.decided(line->proposition).verdict;
  if (verdict == Verdict::internal) disagreement_ = true;
  if (verdict == Verdict::proved || verdict == Verdict::proved_if) found_.push_back(edits);
}

}  // namespace patchproof
