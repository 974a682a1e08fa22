#include <patchproof/mutation/better_data.hpp>

#include <algorithm>

#include <patchproof/mutation/numeric.hpp>

namespace patchproof {

namespace {

/// How often a changed case is decided in the search for one number.
constexpr std::size_t most_looks = 300;
constexpr std::size_t most_candidates = 40;
/// How many numbers one after the other are proposed.
constexpr std::size_t most_numbers = 3;

struct Candidate {
  std::vector<Edit> edits;
  std::string words;
};

bool hides(const Data& data, const std::vector<const Mutant*>& hidden) {
  return std::any_of(hidden.begin(), hidden.end(), [&](const Mutant* m) {
    return std::find(m->data.begin(), m->data.end(), data.name) != m->data.end();
  });
}

Candidate symbols(const CaseMutator& of, const std::vector<const Mutant*>& hidden) {
  Candidate result;
  for (const Data& data : of.data()) {
    if (!hides(data, hidden)) continue;
    result.edits.push_back(CaseMutator::for_symbols(data));
    result.words += (result.words.empty() ? "" : "; ") + data.for_symbols;
  }
  return result;
}

Candidate with_change(const Datum& datum, const Edit& edit) {
  Edit inside = edit;
  inside.begin -= datum.entry.begin;
  inside.end -= datum.entry.begin;
  const std::string old = as_text(datum.entry);
  return {{edit}, datum.owner + " = " + changed(old, {inside}) + " in place of " + old};
}

// Heights first: they break planes, and rarely anything else.
std::vector<Candidate> numbers(const CaseMutator& of, const std::vector<const Mutant*>& hidden) {
  std::vector<Candidate> result;
  for (std::size_t change = 0; change < 2; ++change)
    for (std::size_t coordinate = 0; coordinate < 3; ++coordinate)
      for (const Data& data : of.data()) {
        if (!hides(data, hidden)) continue;
        for (const Datum& datum : data.numbers)
          if (datum.from_last == coordinate)
            result.push_back(with_change(datum, small_changes(data, datum)[change]));
      }
  return result;
}

/// What a candidate comes to.
struct Score {
  std::set<const Mutant*> noticed;
  std::vector<std::string> lost;

  // Claims that go on holding come first: then nothing else of the case has to be changed.
  bool is_less(const Score& other) const {
    if (lost.empty() != other.lost.empty() && !noticed.empty() && !other.noticed.empty())
      return !lost.empty();
    if (noticed.size() != other.noticed.size()) return noticed.size() < other.noticed.size();
    return lost.size() > other.lost.size();
  }
};

Score score_of(const CaseMutator& of, const Candidate& candidate,
               const std::vector<const Mutant*>& hidden) {
  Score result;
  const std::set<std::string> holding = of.holding(candidate.edits);
  if (holding.empty()) return result;
  for (const std::string& name : of.observers())
    if (!holding.contains(name)) result.lost.push_back(name);
  for (const Mutant* mutant : hidden)
    if (of.notices(*mutant, candidate.edits, holding)) result.noticed.insert(mutant);
  return result;
}

}  // namespace

std::vector<BetterData> better_data(const CaseMutator& of,
                                    const std::vector<const Mutant*>& hidden) {
  std::vector<BetterData> result;
  if (hidden.empty()) return result;
  const Candidate general = symbols(of, hidden);
  const Score for_symbols = score_of(of, general, hidden);
  if (!for_symbols.noticed.empty() && for_symbols.lost.empty())
    result.push_back({general.words, true, for_symbols.noticed.size(), {}});
  std::vector<const Mutant*> left = hidden;
  std::vector<Candidate> candidates = numbers(of, hidden);
  std::size_t looks = 0;
  for (std::size_t count = 0; count < most_numbers && !left.empty(); ++count) {
    Score best;
    const Candidate* chosen = nullptr;
    for (std::size_t k = 0; k < std::min(candidates.size(), most_candidates); ++k) {
      if (looks > most_looks) break;
      looks += 1 + left.size();
      const Score score = score_of(of, candidates[k], left);
      if (!best.is_less(score)) continue;
      best = score;
      chosen = &candidates[k];
      if (best.noticed.size() == left.size() && best.lost.empty()) break;
    }
    if (chosen == nullptr || best.noticed.empty()) break;
    result.push_back({chosen->words, false, best.noticed.size(), best.lost});
    std::erase_if(left, [&](const Mutant* m) { return best.noticed.contains(m); });
  }
  return result;
}

}  // namespace patchproof
