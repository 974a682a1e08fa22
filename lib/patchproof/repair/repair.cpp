#include <patchproof/repair/repair.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include <patchproof/repair/orientation.hpp>
#include <patchproof/repair/search.hpp>

namespace patchproof {

namespace {

/// Repairs of several comparisons of one statement are combined; more combinations than these are
/// not of use to anybody.
constexpr std::size_t most_combinations = 200;

/// Thousands of variants of a statement are kept at a time.
constexpr std::size_t longest_statement = 4000;

/// A comparison of the statement, and the ways to make it true.
struct Part {
  std::size_t begin = 0;
  std::vector<std::vector<Edit>> ways;
};

class StatementRepair {
 public:
  StatementRepair(const syntax::Case& written, const syntax::Statement& statement,
                  const syntax::Proposition& printed, const Case& given, const Library& library,
                  const RepairOptions& options)
      : printed_{printed},
        given_{given},
        library_{library},
        options_{options},
        judge_{written, statement, given, library, options.engines},
        budget_{options.most_candidates, given.limits.time} {}

  void run(Repairs& result) {
    try {
      search(result);
    } catch (const SearchStopped&) {
      result.outcome = Repairs::Outcome::stopped;
      result.reason = "stopped after " + std::to_string(budget_.spent()) + " changed statements";
    }
    result.tried = budget_.spent();
  }

 private:
  static void not_tried(Repairs& result, const std::string& why) {
    result.outcome = Repairs::Outcome::not_tried;
    result.reason = why;
  }

  void search(Repairs& result) {
    if (result.printed.size() > longest_statement)
      return not_tried(result, "the statement is longer than " + std::to_string(longest_statement) +
                                   " characters");
    const std::optional<Line> whole = line_of(result.printed);
    if (printed_.joint || printed_.minimum || !whole) return not_tried(result, "only equations are repaired");
    const Names names{judge_.scope(), library_};
    for (const Reversal& reversal : reversals_of(*whole, names)) {
      budget_.spend();
      decide(reversal.edits, reversal.curve, result);
    }
    std::vector<Repair> reversed = std::exchange(result.repairs, {});
    try {
      search_parts(*whole, names, result);
    } catch (const SearchStopped&) {
      if (reversed.empty()) throw;
    }
    // One curve taken backwards is less than two changes.
    const bool less = result.repairs.empty() || result.repairs.front().size() > 1;
    if (!reversed.empty() && less && result.outcome != Repairs::Outcome::internal) {
      result.repairs = std::move(reversed);
      result.complete = true;
      finish(result);
    }
  }

  void search_parts(const Line& whole, const Names& names, Repairs& result) {
    std::vector<Part> parts;
    for (const syntax::Comparison& comparison : whole.proposition.comparisons) {
      const std::optional<Line> line = line_of(whole.text_of(comparison.span));
      if (!line || judge_.may_hold(line->proposition)) continue;
      const bool is_equation = std::all_of(comparison.operators.begin(), comparison.operators.end(),
                                           [](const std::string& sign) { return sign == "=="; });
      if (!is_equation) return not_tried(result, "only equations are repaired");
      ComparisonSearch search{*line, judge_, names, given_.limits, options_.most_changes, budget_};
      parts.push_back({Line::begin_of(comparison.span), search.least()});
      if (search.stopped()) result.complete = false;
      if (search.disagreement()) {
        result.outcome = Repairs::Outcome::internal;
        result.reason = "the engines disagree about a changed statement";
        return;
      }
      if (parts.back().ways.empty()) {
        result.reason = "no change of at most " + std::to_string(options_.most_changes) +
                        (options_.most_changes == 1 ? " place" : " places") + " makes it true";
        return;
      }
    }
    if (parts.empty()) return not_tried(result, "each of its comparisons may be true by itself");
    std::vector<Edit> chosen;
    combine(parts, 0, chosen, result);
    finish(result);
  }

  void combine(const std::vector<Part>& parts, std::size_t next, std::vector<Edit>& chosen,
               Repairs& result) {
    if (result.repairs.size() >= most_combinations) {
      result.complete = false;
      return;
    }
    if (next == parts.size()) return decide(chosen, "", result);
    const std::size_t before = chosen.size();
    for (const std::vector<Edit>& way : parts[next].ways) {
      for (Edit edit : way) {
        edit.begin += parts[next].begin;
        edit.end += parts[next].begin;
        chosen.push_back(std::move(edit));
      }
      combine(parts, next + 1, chosen, result);
      chosen.resize(before);
    }
  }

  void decide(const std::vector<Edit>& edits, const std::string& curve, Repairs& result) {
    const std::string text = changed(result.printed, edits);
    const std::optional<Line> line = line_of(text);
    if (!line) return;
    const CandidateJudge::Verdicts verdicts = judge_.decided(line->proposition);
    if (verdicts.verdict != Verdict::proved && verdicts.verdict != Verdict::proved_if) return;
    result.repairs.push_back(
        {edits, text, verdicts.verdict, verdicts.evidence, verdicts.conditions, curve});
  }

  static void finish(Repairs& result) {
    std::stable_sort(result.repairs.begin(), result.repairs.end(),
                     [](const Repair& a, const Repair& b) {
                       return a.verdict == Verdict::proved && b.verdict != Verdict::proved;
                     });
    if (result.repairs.empty())
      result.reason = "no change of its parts makes the whole true";
    else
      result.outcome = Repairs::Outcome::found;
  }

  const syntax::Proposition& printed_;
  const Case& given_;
  const Library& library_;
  const RepairOptions& options_;
  CandidateJudge judge_;
  SearchBudget budget_;
};

const syntax::Statement* statement_of(const syntax::Case& written, const Claim& claim) {
  for (const syntax::Statement& statement : written.statements)
    if (statement.span.begin == claim.span.begin) return &statement;
  return nullptr;
}

}  // namespace

std::vector<Repairs> repairs_of(const syntax::Case& written, const Case& given,
                                const Library& library, const RepairOptions& options) {
  VerificationOptions verification;
  verification.engines = options.engines;
  if (options.wanted)
    verification.wanted = [&](const Claim& claim) { return options.wanted(given, claim); };
  Case silent = given;
  silent.shown.clear();
  const CaseResult decided = verified(silent, verification);
  std::vector<Repairs> result;
  // A place and a label: what makes a family.
  std::map<std::pair<std::size_t, std::string>, std::size_t> known;
  std::vector<const Claim*> first;
  for (const ClaimResult& claim : decided.claims) {
    if (claim.decision.verdict != Verdict::refuted) continue;
    const auto [place, fresh] =
        known.emplace(std::make_pair(claim.claim.span.begin, claim.claim.label), result.size());
    if (!fresh) {
      ++result[place->second].instances;
      continue;
    }
    Repairs& repairs = result.emplace_back();
    repairs.id = given.name + "." + claim.claim.label;
    // What a derivation says of its unknowns stands outside of its equations.
    const bool derives = claim.claim.verb == "derive";
    repairs.statement = derives ? claim.claim.span : claim.claim.statement;
    first.push_back(&claim.claim);
  }
  for (std::size_t k = 0; k < result.size(); ++k) {
    Repairs& repairs = result[k];
    repairs.printed = in_one_line(repairs.statement);
    const syntax::Statement* statement = statement_of(written, *first[k]);
    if (statement == nullptr || first[k]->verb == "derive") {
      repairs.outcome = Repairs::Outcome::not_tried;
      repairs.reason = "'check' shows what is derived instead";
      continue;
    }
    const syntax::Proposition& printed = first[k]->verb == "printed"     ? statement->printed
                                         : first[k]->verb == "corrected" ? statement->corrected
                                                                         : statement->proposition;
    StatementRepair{written, *statement, printed, given, library, options}.run(repairs);
  }
  return result;
}

}  // namespace patchproof
