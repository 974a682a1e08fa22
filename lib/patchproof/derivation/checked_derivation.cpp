#include <patchproof/derivation/checked_derivation.hpp>

#include <algorithm>

#include <patchproof/decide/decide.hpp>
#include <patchproof/term/plain_text.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

// More than this no reader follows; it keeps the message of a false step readable too.
constexpr std::size_t longest_shown = 300;

bool is_proof(const Decision& decision) {
  return decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
}

class Checker {
 public:
  Checker(const Passage& passage, const Limits& limits, Engines engines)
      : given_{passage.given}, conditions_{passage.conditions}, limits_{limits}, engines_{engines} {}

  CheckedChain of(const Chain& chain) const {
    CheckedChain result{chain.start, {}};
    Term before = chain.start;
    for (std::size_t k = 0; k < chain.links.size(); ++k) {
      const Link& link = chain.links[k];
      Decision decision = decided_link(before, link);
      if (!is_proof(decision) || needs_more(decision)) {
        // An equation left open is skipped; an inequality is the point of its chain.
        if (link.relation == Relation::equal && k + 1 < chain.links.size()) continue;
        return {chain.start, {}};
      }
      before = link.term;
      result.links.push_back({link, std::move(decision)});
    }
    return result;
  }

 private:
  Decision decided_link(const Term& before, const Link& link) const {
    Goal goal = given_;
    goal.statements = {{before, link.relation, link.term, link.term.span()}};
    Decision decision = decided(goal, limits_, engines_);
    if (decision.verdict == Verdict::refuted || decision.verdict == Verdict::internal)
      throw FalseStep{"a step of a derivation is " + to_text(decision.verdict) + ": " +
                      to_text(before, longest_shown) + " against " +
                      to_text(link.term, longest_shown)};
    if (link.relation == Relation::not_equal && is_proof(decision) && are_numbers(goal))
      confirm_difference(goal, decision);
    return decision;
  }

  // A step that holds under conditions the claim does not have is not one of its proof.
  bool needs_more(const Decision& decision) const {
    if (!conditions_) return false;
    return std::any_of(decision.conditions.begin(), decision.conditions.end(),
                       [&](const std::string& condition) {
                         return std::find(conditions_->begin(), conditions_->end(), condition) ==
                                conditions_->end();
                       });
  }

  // Nothing is free in the two sides but what has a value.
  bool are_numbers(const Goal& goal) const {
    for (const auto& [ordinal, symbol] : free_symbols(goal)) {
      const bool known =
          std::any_of(goal.known.begin(), goal.known.end(),
                      [o = ordinal](const KnownValue& k) { return k.symbol->ordinal == o; });
      if (!known) return false;
    }
    return true;
  }

  // The second engine speaks of equations only. Numbers are not equal where the equation is false.
  void confirm_difference(Goal& goal, Decision& decision) const {
    goal.statements.front().relation = Relation::equal;
    const Decision equality = decided(goal, limits_, engines_);
    if (equality.verdict == Verdict::refuted) decision.evidence = equality.evidence;
  }

  const Goal& given_;
  const std::optional<std::vector<std::string>>& conditions_;
  const Limits& limits_;
  Engines engines_;
};

CheckedChain undecided(const Chain& chain) {
  CheckedChain result{chain.start, {}};
  for (const Link& link : chain.links) result.links.push_back({link, {}});
  return result;
}

}  // namespace

CheckedDerivation::CheckedDerivation(const Derivation& proposed, const Limits& limits,
                                     Engines engines) {
  for (const Passage& passage : proposed.passages) {
    CheckedPassage checked{passage.kind, {}, passage.values, passage.open};
    const Checker checker{passage, limits, engines};
    for (const Chain& chain : passage.chains) {
      CheckedChain result =
          passage.open ? undecided(chain) : checker.of(chain);
      if (!result.links.empty()) checked.chains.push_back(std::move(result));
    }
    if (!checked.chains.empty() || !checked.values.empty()) passages_.push_back(std::move(checked));
  }
}

}  // namespace patchproof
