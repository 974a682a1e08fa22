#include <patchproof/mutation/better_data.hpp>

#include <algorithm>

#include <patchproof/mutation/numeric.hpp>

namespace patchproof {

namespace {

/// How often a changed case is decided in the search for one number.
constexpr std::size_t most_looks = 600;
/// How many numbers one after the other are proposed.
constexpr std::size_t most_numbers = 3;

struct Candidate {
  std::vector<Edit> edits;
  std::string words;
  /// Curves that no longer meet would only make claims false.
  bool is_function = false;
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
  return {{edit}, datum.owner + " = " + changed(old, {inside}) + " in place of " + old, false};
}

bool is_curve(const Data& data) {
  return data.is_function && data.statement->declarators.front().parameters.size() == 1;
}

// The height of the curve raised at the end where t or 1-t is 1.
Candidate raised(const Data& curve, bool at_end) {
  const std::string t = curve.statement->declarators.front().parameters.front().text;
  const Datum& height = curve.numbers.back();
  const Span& span = height.value->span;
  const std::string old = as_text(span);
  const std::string more = at_end ? t : "1-" + t;
  return with_change(height,
                     {span.begin, span.end, old == "0" ? more : old + " + " + more, "datum"});
}

/// Two curves that meet can have their common end elsewhere.
void add_corners(const CaseMutator& of, std::vector<Candidate>& result) {
  for (const Data& first : of.data())
    for (const Data& second : of.data()) {
      if (!is_curve(first) || !is_curve(second) || &first >= &second) continue;
      for (const bool first_end : {false, true})
        for (const bool second_end : {false, true}) {
          Candidate candidate = raised(first, first_end);
          const Candidate other = raised(second, second_end);
          candidate.edits.push_back(other.edits.front());
          candidate.words += " and " + other.words;
          candidate.is_function = true;
          result.push_back(std::move(candidate));
        }
    }
}

// Heights first: they break planes, and rarely anything else.
std::vector<Candidate> numbers(const CaseMutator& of, const std::vector<const Mutant*>& hidden) {
  std::vector<Candidate> result;
  for (std::size_t change = 0; change < 2; ++change)
    for (std::size_t coordinate = 0; coordinate < 3; ++coordinate)
      for (const Data& data : of.data()) {
        if (!hides(data, hidden)) continue;
        for (const Datum& datum : data.numbers) {
          if (datum.from_last != coordinate) continue;
          result.push_back(with_change(datum, small_changes(data, datum)[change]));
          result.back().is_function = data.is_function;
        }
      }
  add_corners(of, result);
  return result;
}

/// What a candidate comes to.
struct Score {
  const Candidate* candidate = nullptr;
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

Score score_of(const CaseMutator& of, const Candidate& candidate,
               const std::vector<const Mutant*>& hidden) {
  Score result{&candidate, {}, {}};
  const CaseMutator::Findings before = of.findings(candidate.edits);
  for (const auto& [name, finding] : before)
    if (!finding.empty()) result.lost.push_back(name);
  if (before.size() != of.observers().size()) return {};
  if (candidate.is_function && !result.lost.empty()) return {};
  for (const Mutant* mutant : hidden)
    if (notices(before, of.findings(candidate.edits, *mutant))) result.noticed.insert(mutant);
  return result;
}

bool overlaps(const Candidate& a, const Candidate& b) {
  for (const Edit& first : a.edits)
    for (const Edit& second : b.edits)
      if (overlap(first, second)) return true;
  return false;
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
      const Candidate next = *best->candidate;
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
  void add(const Candidate& next) {
    if (overlaps(together_, next)) return;
    Candidate both = together_;
    both.edits.insert(both.edits.end(), next.edits.begin(), next.edits.end());
    both.is_function = both.is_function || next.is_function;
    const Score score = score_of(of_, both, hidden_);
    if (score.noticed.size() <= noticed_.size()) return;
    together_ = both;
    noticed_ = score.noticed;
    result_.push_back({next.words, false, noticed_.size(), score.lost});
  }

  const CaseMutator& of_;
  const std::vector<const Mutant*>& hidden_;
  std::vector<Score> scores_;
  Candidate together_;
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
  const Candidate general = symbols(of, hidden);
  const Score for_symbols = score_of(of, general, hidden);
  if (!for_symbols.noticed.empty() && for_symbols.lost.empty())
    return {{general.words, true, for_symbols.noticed.size(), {}}};
  const std::vector<Candidate> candidates = numbers(of, hidden);
  std::vector<Score> scores;
  std::size_t looks = 0;
  for (const Candidate& candidate : candidates) {
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
