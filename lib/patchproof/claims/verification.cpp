#include <patchproof/claims/verification.hpp>

#include <algorithm>

#include <patchproof/decide/decide.hpp>
#include <patchproof/decide/shown.hpp>
#include <patchproof/term/plain_text.hpp>

namespace patchproof {

std::string to_text(Expectation expectation) {
  switch (expectation) {
    case Expectation::prove:
      return "prove";
    case Expectation::refute:
      return "refute";
    case Expectation::open:
      return "open";
    default:
      return "inconsistent";
  }
}

Outcome outcome_of(Expectation expectation, Verdict verdict) {
  if (verdict == Verdict::internal) return Outcome::internal;
  if (verdict == Verdict::error) return Outcome::error;
  if (verdict == Verdict::vacuous) return Outcome::vacuous;
  const auto expected_if = [](bool good) { return good ? Outcome::as_expected : Outcome::wrong; };
  if (expectation == Expectation::open) return expected_if(verdict == Verdict::unknown);
  if (verdict == Verdict::unknown) return Outcome::unknown;
  switch (expectation) {
    case Expectation::prove:
      return expected_if(verdict == Verdict::proved || verdict == Verdict::proved_if);
    case Expectation::refute:
      return expected_if(verdict == Verdict::refuted);
    default:
      return expected_if(verdict == Verdict::inconsistent);
  }
}

namespace {

Decision decide_identity(const IdentityClaim& claim, const std::vector<KnownValue>& known,
                         const std::vector<Assumption>& agreements, const Case& given,
                         Engines engines) {
  Goal goal = claim.goal;
  goal.known = known;
  goal.assumptions.insert(goal.assumptions.end(), agreements.begin(), agreements.end());
  return decided(goal, given.limits, engines);
}

Decision decide_derive(const DeriveClaim& claim, const std::vector<KnownValue>& known,
                       const std::vector<Assumption>& agreements, const Case& given,
                       Engines engines) {
  SolveGoal goal = claim.goal;
  goal.goal.known = known;
  std::vector<Assumption>& assumptions = goal.goal.assumptions;
  assumptions.insert(assumptions.end(), agreements.begin(), agreements.end());
  return solved(goal, claim.gives, claim.leaves, given.limits, engines);
}

Decision decide_minimum(const MinimumClaim& claim, const std::vector<KnownValue>& known,
                        const std::vector<Assumption>& agreements, const Case& given,
                        Engines engines) {
  MinimumGoal goal = claim.goal;
  goal.goal.known = known;
  std::vector<Assumption>& assumptions = goal.goal.assumptions;
  assumptions.insert(assumptions.end(), agreements.begin(), agreements.end());
  return minimum(goal, given.limits, engines);
}

bool is_solved(const Decision& decision) {
  return decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
}

}  // namespace

CaseVerifier::CaseVerifier(const Case& given, Engines engines, std::function<void()> begins)
    : given_{given}, engines_{engines}, begins_{std::move(begins)} {
  for (std::size_t k = 0; k < given.claims.size(); ++k)
    if (given.claims[k].verb == "derive")
      derivations_[given.claims[k].label][given.claims[k].instance] = k;
}

// That of the same instance, or of the family instance this one belongs to.
std::optional<std::size_t> CaseVerifier::derivation_for(const std::string& label,
                                                        const std::string& instance,
                                                        std::size_t before) const {
  const auto found = derivations_.find(label);
  if (found == derivations_.end()) return std::nullopt;
  for (std::string outer = instance;;) {
    const auto place = found->second.find(outer);
    if (place != found->second.end() && place->second < before) return place->second;
    if (outer.empty()) return std::nullopt;
    const std::size_t comma = outer.rfind(',');
    outer = comma == std::string::npos ? "" : outer.substr(0, comma) + "]";
  }
}

// All that it uses, and what those use; each uses only earlier ones.
std::set<std::size_t> CaseVerifier::derivations_below(std::size_t index) const {
  std::set<std::size_t> result;
  std::vector<std::size_t> open{index};
  while (!open.empty()) {
    const std::size_t user = open.back();
    open.pop_back();
    const Claim& claim = given_.claims[user];
    for (const std::string& label : claim.uses)
      if (const auto used = derivation_for(label, claim.instance, user))
        if (result.insert(*used).second) open.push_back(*used);
  }
  return result;
}

Decision CaseVerifier::decision_of(std::size_t index, ClaimResult& result_of_claim) const {
  const Claim& claim = given_.claims[index];
  std::vector<KnownValue>& known = result_of_claim.known;
  std::vector<Assumption>& agreements = result_of_claim.agreements;
  std::vector<std::string> conditions;
  for (const std::string& label : claim.uses) {
    const auto used = derivation_for(label, claim.instance, index);
    const Decision* found = used ? &decided_derivations_.at(*used).decision : nullptr;
    if (found == nullptr || !is_solved(*found)) {
      Decision undecided;
      undecided.reason = "it uses '" + label + "', which is not derived";
      return undecided;
    }
    for (const KnownValue& value : found->solution) {
      const auto before = std::find_if(known.begin(), known.end(), [&](const KnownValue& k) {
        return k.symbol->ordinal == value.symbol->ordinal;
      });
      // Derived twice: both values are used, so they have to agree.
      if (before != known.end())
        agreements.push_back({label, {before->value, Relation::equal, value.value, claim.span}});
      else
        known.push_back(value);
    }
    conditions.insert(conditions.end(), found->conditions.begin(), found->conditions.end());
  }
  Decision result = std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (std::is_same_v<Kind, IdentityClaim>)
          return decide_identity(kind, known, agreements, given_, engines_);
        else if constexpr (std::is_same_v<Kind, DeriveClaim>)
          return decide_derive(kind, known, agreements, given_, engines_);
        else
          return decide_minimum(kind, known, agreements, given_, engines_);
      },
      claim.kind);
  // What the derivation needs, everything built on it needs as well.
  if (result.verdict == Verdict::proved && !conditions.empty()) result.verdict = Verdict::proved_if;
  for (const std::string& condition : conditions)
    if (std::find(result.conditions.begin(), result.conditions.end(), condition) ==
        result.conditions.end())
      result.conditions.push_back(condition);
  return result;
}

ClaimResult CaseVerifier::decide(std::size_t index) const {
  const Claim& claim = given_.claims.at(index);
  if (begins_) begins_();
  const auto start = std::chrono::steady_clock::now();
  ClaimResult result{claim, {}, {}, {}};
  result.decision = decision_of(index, result);
  result.time = std::chrono::duration_cast<std::chrono::microseconds>(
      std::chrono::steady_clock::now() - start);
  result.outcome = outcome_of(claim.expectation, result.decision.verdict);
  return result;
}

ClaimResult CaseVerifier::decided(std::size_t index) {
  for (const std::size_t used : derivations_below(index))
    if (!decided_derivations_.contains(used)) decided_derivations_.emplace(used, decide(used));
  const auto known = decided_derivations_.find(index);
  if (known != decided_derivations_.end()) return known->second;
  ClaimResult result = decide(index);
  if (given_.claims[index].verb == "derive") decided_derivations_.emplace(index, result);
  return result;
}

ShownResult CaseVerifier::described(std::size_t index) const {
  const Shown& shown = given_.shown.at(index);
  ShownResult result{shown.span, shown.instance, "", "", std::nullopt};
  if (shown.joint) {
    result.joint = joint_report(*shown.joint, given_.limits);
    result.value = in_words(*result.joint);
  } else {
    result.term = to_text(shown.term);
    result.value = normal_form_in_words(shown.term, given_.limits);
  }
  return result;
}

CaseResult verified(const Case& given, const VerificationOptions& options) {
  CaseResult result;
  result.verified = given;
  CaseVerifier verifier{given, options.engines};
  for (std::size_t k = 0; k < given.claims.size(); ++k) {
    if (options.wanted && !options.wanted(given.claims[k])) continue;
    if (options.progress) options.progress(given.claims[k]);
    result.claims.push_back(verifier.decided(k));
  }
  for (std::size_t k = 0; k < given.shown.size(); ++k)
    result.shown.push_back(verifier.described(k));
  return result;
}

}  // namespace patchproof
