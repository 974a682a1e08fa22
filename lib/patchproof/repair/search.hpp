#pragma once

#include <set>

#include <patchproof/repair/candidate.hpp>
#include <patchproof/repair/line.hpp>
#include <patchproof/repair/names.hpp>
#include <patchproof/repair/repair.hpp>

namespace patchproof {

/// Thrown when the search has looked at as many candidates, or taken as long, as it may.
struct SearchStopped {};

/// What one search may cost, over all comparisons of the statement.
class SearchBudget {
 public:
  SearchBudget(std::size_t most_candidates, std::chrono::milliseconds time)
      : most_{most_candidates},
        end_{std::chrono::steady_clock::now() + time},
        timed_{time.count() != 0} {}

  /// Counts one candidate, whatever becomes of it. @throws SearchStopped
  void spend();
  std::size_t spent() const { return spent_; }

 private:
  std::size_t most_;
  std::chrono::steady_clock::time_point end_;
  bool timed_;
  std::size_t spent_ = 0;
};

/// Looks for the smallest changes of one false comparison, by itself, that make it true.
class ComparisonSearch {
 public:
  /// The line holds one comparison.
  ComparisonSearch(const Line& line, CandidateJudge& judge, const Names& names,
                   const Limits& limits, std::size_t most_changes, SearchBudget& budget);

  /// All of the least size; none when there are none. @throws SearchStopped
  std::vector<std::vector<Edit>> least();

  /// Whether the budget ended the search when something had been found.
  bool stopped() const { return stopped_; }
  /// Whether the two engines disagreed about some candidate.
  bool disagreement() const { return disagreement_; }

 private:
  void search();
  /// Tries all combinations of so many changes, the first `chosen` of which are chosen.
  void combine(std::size_t count, std::size_t from, std::vector<Edit>& chosen);
  void try_edits(const std::vector<Edit>& edits);

  const Line& line_;
  CandidateJudge& judge_;
  const Names& names_;
  const Limits& limits_;
  std::size_t most_changes_;
  SearchBudget& budget_;
  std::vector<Edit> all_;
  /// What was tried, in canonical form.
  std::set<std::string> seen_;
  std::vector<std::vector<Edit>> found_;
  bool stopped_ = false;
  bool disagreement_ = false;
};

}  // namespace patchproof
