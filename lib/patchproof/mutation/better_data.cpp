#include <patchproof/mutation/better_data.hpp>

#include <algorithm>

#include <patchproof/mutation/data_candidate.hpp>

namespace patchproof {

namespace {

/// How often a changed case is decided in the search for one number.
constexpr std::size_t most_looks = 600;
/// How many numbers one after the other are proposed.
constexpr std::size_t most_numbers = 3;

/// What a candidate comes to.
struct Score {
  const DataCandidate* candidate = nullptr;
  std::set<const Mutant*> noticed;
  /// Claims that are false then, because they speak of other numbers.
  std::vector<std::string> lost;
};

// A claim whose numbers are others notices an error when that changes how far it is off.
bool notices(const CaseMutator::Findings& before, const CaseMutator::Findings& after) {
  return std::any_of(before.begin(), before.end(), [&](const auto& finding) {
    const auto other = after.find(finding.first);
    return other != after.end() && other->second != finding.second;
  });
}

Score score_of(const CaseMutator& of, const DataCandidate& candidate,
               const std::vector<const Mutant*>& hidden) {
  Score result{&candidate, {}, {}};
  const CaseMutator::Findings before = of.findings(candidate.edits);
  for (const auto& [name, finding] : before)
    if (!finding.empty()) result.lost.push_back(name);
  if (before.size() != of.observers().size()) return {};
  if (candidate.moves_ends && !result.lost.empty()) return {};
  for (const Mutant* mutant : hidden)
    if (notices(before, of.findings(candidate.edits, *mutant))) result.noticed.insert(mutant);
  return result;
}

/// Puts candidates together, one after the other: each time the one that shows most of what is
/// left; those come first that leave all claims as they are.
class Choice {
 public:
  Choice(const CaseMutator& of, const std::vector<const Mutant*>& hidden, std::vector<Score> scores)
      : of_{of}, hidden_{hidden}, scores_{std::move(scores)} {}

  std::vector<BetterData> chosen() {
    take(false);
    take(true);
    return std::move(result_);
  }

 private:
  void take(bool may_lose) {
    while (result_.size() < most_numbers && noticed_.size() < hidden_.size()) {
      const auto best =
          std::max_element(scores_.begin(), scores_.end(), [&](const Score& a, const Score& b) {
            return value_of(a, may_lose) < value_of(b, may_lose);
          });
      if (best == scores_.end() || value_of(*best, may_lose).first == 0) return;
      const DataCandidate next = *best->candidate;
      scores_.erase(best);
      add(next);
    }
  }

  /// How much is new, and how few claims are lost.
  std::pair<std::size_t, std::size_t> value_of(const Score& score, bool may_lose) const {
    if (!may_lose && !score.lost.empty()) return {0, 0};
    std::size_t fresh = 0;
    for (const Mutant* mutant : score.noticed) fresh += noticed_.contains(mutant) ? 0 : 1;
    return {fresh, of_.observers().size() - score.lost.size()};
  }

  // What two changes show together is decided anew.
  void add(const DataCandidate& next) {
    if (overlaps(together_, next)) return;
    const DataCandidate joined = both(together_, next);
    const Score score = score_of(of_, joined, hidden_);
    if (score.noticed.size() <= noticed_.size()) return;
    together_ = joined;
    noticed_ = score.noticed;
    result_.push_back({in_words(next, together_), false, noticed_.size(), score.lost});
  }

  const CaseMutator& of_;
  const std::vector<const Mutant*>& hidden_;
  std::vector<Score> scores_;
  DataCandidate together_;
  std::set<const Mutant*> noticed_;
  std::vector<BetterData> result_;
};

}  // namespace

bool hides(const Data& data, const std::vector<const Mutant*>& hidden) {
  return std::any_of(hidden.begin(), hidden.end(), [&](const Mutant* m) {
    return std::find(m->data.begin(), m->data.end(), data.name) != m->data.end();
  });
}

std::vector<BetterData> better_data(const CaseMutator& of,
                                    const std::vector<const Mutant*>& hidden) {
  DataCandidate general;
  std::string declared;
  std::vector<const Data*> hiding;
  for (const Data& data : of.data()) {
    if (!hides(data, hidden)) continue;
    hiding.push_back(&data);
    general.edits.push_back(CaseMutator::for_symbols(data));
    declared += (declared.empty() ? "" : "; ") + data.for_symbols;
  }
  const Score for_symbols = score_of(of, general, hidden);
  if (!for_symbols.noticed.empty() && for_symbols.lost.empty())
    return {{declared, true, for_symbols.noticed.size(), {}}};
  const std::vector<DataCandidate> candidates = data_candidates(hiding, of.data());
  std::vector<Score> scores;
  std::size_t looks = 0;
  for (const DataCandidate& candidate : candidates) {
    if (looks > most_looks) break;
    Score score = score_of(of, candidate, hidden);
    looks += score.candidate == nullptr ? 1 : 1 + hidden.size();
    if (score.candidate == nullptr) continue;
    const bool is_enough = score.lost.empty() && score.noticed.size() == hidden.size();
    scores.push_back(std::move(score));
    if (is_enough) break;
  }
  return Choice{of, hidden, std::move(scores)}.chosen();
}

}  // namespace patchproof
