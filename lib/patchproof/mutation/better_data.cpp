#include <patchproof/mutation/better_data.hpp>

#include <algorithm>

#include <patchproof/mutation/numeric.hpp>

namespace patchproof {

namespace {

/// How often a changed case is decided in the search for one number.
constexpr std::size_t most_looks = 1000;
/// How many numbers one after the other are proposed.
constexpr std::size_t most_numbers = 3;

struct Candidate {
  std::vector<Edit> edits;
  std::string words;
};

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
  const Candidate* candidate = nullptr;
  std::set<const Mutant*> noticed;
  /// Claims that speak of numbers that are others then.
  std::vector<std::string> lost;
};

// A claim whose numbers are others notices an error when that changes how far it is off.
bool notices(const CaseMutator::Findings& before, const CaseMutator::Findings& after) {
  return std::any_of(before.begin(), before.end(), [&](const auto& finding) {
    const auto other = after.find(finding.first);
    return other != after.end() && other->second != finding.second;
  });
}

Score score_of(const CaseMutator& of, const Candidate& candidate,
               const std::vector<const Mutant*>& hidden) {
  Score result{&candidate, {}, {}};
  const CaseMutator::Findings before = of.findings(candidate.edits);
  for (const auto& [name, finding] : before)
    if (!finding.empty()) result.lost.push_back(name);
  if (before.size() != of.observers().size()) return {};
  for (const Mutant* mutant : hidden)
    if (notices(before, of.findings(candidate.edits, *mutant))) result.noticed.insert(mutant);
  return result;
}

/// Takes the scores that notice most of what is left, those first that leave all claims as they
/// are.
void choose(std::vector<Score> scores, std::set<const Mutant*> left, bool may_lose,
            std::vector<BetterData>& result) {
  while (result.size() < most_numbers && !left.empty()) {
    const Score* best = nullptr;
    std::size_t most = 0;
    for (Score& score : scores) {
      if (!may_lose && !score.lost.empty()) continue;
      std::erase_if(score.noticed, [&](const Mutant* m) { return !left.contains(m); });
      const bool is_better =
          score.noticed.size() > most ||
          (best != nullptr && score.noticed.size() == most && score.lost.size() < best->lost.size());
      if (!is_better || score.noticed.empty()) continue;
      best = &score;
      most = score.noticed.size();
    }
    if (best == nullptr) {
      if (may_lose) return;
      may_lose = true;
      continue;
    }
    result.push_back({best->candidate->words, false, most, best->lost});
    const std::set<const Mutant*> noticed = best->noticed;
    std::erase_if(left, [&](const Mutant* m) { return noticed.contains(m); });
  }
}

}  // namespace

bool hides(const Data& data, const std::vector<const Mutant*>& hidden) {
  return std::any_of(hidden.begin(), hidden.end(), [&](const Mutant* m) {
    return std::find(m->data.begin(), m->data.end(), data.name) != m->data.end();
  });
}

std::vector<BetterData> better_data(const CaseMutator& of,
                                    const std::vector<const Mutant*>& hidden) {
  const Candidate general = symbols(of, hidden);
  const Score for_symbols = score_of(of, general, hidden);
  if (!for_symbols.noticed.empty() && for_symbols.lost.empty())
    return {{general.words, true, for_symbols.noticed.size(), {}}};
  const std::vector<Candidate> candidates = numbers(of, hidden);
  std::vector<Score> scores;
  std::size_t looks = 0;
  for (const Candidate& candidate : candidates) {
    looks += 1 + hidden.size();
    if (looks > most_looks) break;
    scores.push_back(score_of(of, candidate, hidden));
  }
  std::vector<BetterData> result;
  choose(scores, {hidden.begin(), hidden.end()}, false, result);
  return result;
}

}  // namespace patchproof
