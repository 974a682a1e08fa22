#include <patchproof/claims/without_assumptions.hpp>

#include <algorithm>

#include <patchproof/claims/verification.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

Goal& goal_of(IdentityClaim& claim) { return claim.goal; }
Goal& goal_of(DeriveClaim& claim) { return claim.goal.goal; }
Goal& goal_of(MinimumClaim& claim) { return claim.goal.goal; }

Goal& goal_of(Claim& claim) {
  return std::visit([](auto& kind) -> Goal& { return goal_of(kind); }, claim.kind);
}

Goal goal_of(const Claim& claim) {
  Claim copy = claim;
  return goal_of(copy);
}

using Ordinals = std::set<unsigned>;

void add_symbols(const Statement& statement, bool with_parameters, Ordinals& result) {
  for (const Term& side : {statement.left, statement.right})
    for (const auto& [ordinal, symbol] : free_symbols(side))
      if (with_parameters || symbol->role != Symbol::Role::parameter) result.insert(ordinal);
}

bool meet(const Ordinals& a, const Ordinals& b) {
  return std::any_of(a.begin(), a.end(), [&](unsigned k) { return b.contains(k); });
}

// The derivations a claim uses, and those that these use.
void add_used(const Case& given, const Claim& claim, std::set<std::string>& labels) {
  for (const std::string& label : claim.uses) {
    if (!labels.insert(label).second) continue;
    for (const Claim& other : given.claims)
      if (other.verb == "derive" && other.label == label) add_used(given, other, labels);
  }
}

}  // namespace

std::string assumption_name(const std::string& label, std::size_t index) {
  return label.empty() ? "assumption " + std::to_string(index + 1) : label;
}

std::vector<std::string> assumption_names(const Claim& claim) {
  std::vector<std::string> names;
  const std::vector<Assumption> assumptions = goal_of(claim).assumptions;
  for (std::size_t k = 0; k < assumptions.size(); ++k) {
    const std::string name = assumption_name(assumptions[k].label, k);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

std::set<std::string> related_assumptions(const Case& given, const Claim& claim) {
  const Goal goal = goal_of(claim);
  Ordinals reached;
  for (const Statement& statement : goal.statements) add_symbols(statement, true, reached);
  std::set<std::string> used;
  add_used(given, claim, used);
  for (const Claim& other : given.claims)
    if (other.verb == "derive" && used.contains(other.label))
      for (const Goal goal_of_other = goal_of(other);
           const Statement& statement : goal_of_other.statements)
        add_symbols(statement, true, reached);
  std::set<std::string> result;
  std::vector<bool> done(goal.assumptions.size(), false);
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t k = 0; k < goal.assumptions.size(); ++k) {
      const Statement& statement = goal.assumptions[k].statement;
      Ordinals symbols;
      add_symbols(statement, statement.relation != Relation::equal, symbols);
      if (done[k] || !meet(symbols, reached)) continue;
      done[k] = grows = true;
      reached.insert(symbols.begin(), symbols.end());
      result.insert(assumption_name(goal.assumptions[k].label, k));
    }
  }
  return result;
}

Decision decided_without(const Case& given, const Claim& claim,
                         const std::set<std::string>& names) {
  Claim fewer = claim;
  std::vector<Assumption>& assumptions = goal_of(fewer).assumptions;
  std::vector<Assumption> kept;
  for (std::size_t k = 0; k < assumptions.size(); ++k)
    if (!names.contains(assumption_name(assumptions[k].label, k))) kept.push_back(assumptions[k]);
  assumptions = std::move(kept);
  std::set<std::string> used;
  add_used(given, claim, used);
  Case alone = given;
  alone.shown.clear();
  alone.claims.clear();
  for (const Claim& other : given.claims)
    if (other.verb == "derive" && used.contains(other.label)) alone.claims.push_back(other);
  alone.claims.push_back(fewer);
  VerificationOptions options;
  options.engines = Engines::kernel;
  const ClaimResult last = verified(alone, options).claims.back();
  return last.decision;
}

}  // namespace patchproof
