#include <patchproof/claims/verification.hpp>

#include <algorithm>
#include <map>

#include <patchproof/decide/decide.hpp>
#include <patchproof/decide/shown.hpp>
#include <patchproof/term/plain_text.hpp>

namespace patchproof {

std::string to_text(Expectation expectation) {
  switch (expectation) {
    case Expectation::prove: return "prove";
    case Expectation::refute: return "refute";
    case Expectation::open: return "open";
    default: return "inconsistent";
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
    case Expectation::refute: return expected_if(verdict == Verdict::refuted);
    default: return expected_if(verdict == Verdict::inconsistent);
  }
}

namespace {

struct Handed {
  std::vector<KnownValue> values;
  std::vector<std::string> conditions;
  bool solved = false;
};
/// Label -> instance -> what was derived there.
using Derivations = std::map<std::string, std::map<std::string, Handed>>;

// The derivation of the same instance, or of the family instance this one belongs to.
const Handed* derivation_for(const std::string& label, const std::string& instance,
                             const Derivations& derivations) {
  const auto found = derivations.find(label);
  if (found == derivations.end()) return nullptr;
  for (std::string outer = instance; !outer.empty();) {
    const auto handed = found->second.find(outer);
    if (handed != found->second.end()) return &handed->second;
    const std::size_t comma = outer.rfind(',');
    outer = comma == std::string::npos ? "" : outer.substr(0, comma) + "]";
  }
  const auto handed = found->second.find("");
  return handed == found->second.end() ? nullptr : &handed->second;
}

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

// Decides the claim of the result, and notes there what it uses.
Decision decide(ClaimResult& result_of_claim, const Derivations& derivations, const Case& given,
                Engines engines) {
  const Claim& claim = result_of_claim.claim;
  std::vector<KnownValue>& known = result_of_claim.known;
  std::vector<Assumption>& agreements = result_of_claim.agreements;
  std::vector<std::string> conditions;
  for (const std::string& label : claim.uses) {
    const Handed* found = derivation_for(label, claim.instance, derivations);
    if (found == nullptr || !found->solved) {
      Decision undecided;
      undecided.reason = "it uses '" + label + "', which is not derived";
      return undecided;
    }
    const Handed& handed = *found;
    for (const KnownValue& value : handed.values) {
      const auto before = std::find_if(known.begin(), known.end(), [&](const KnownValue& k) {
        return k.symbol->ordinal == value.symbol->ordinal;
      });
      // Derived twice: both values are used, so they have to agree.
      if (before != known.end())
        agreements.push_back({label, {before->value, Relation::equal, value.value, claim.span}});
      else
        known.push_back(value);
    }
    conditions.insert(conditions.end(), handed.conditions.begin(), handed.conditions.end());
  }
  Decision result = std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (std::is_same_v<Kind, IdentityClaim>)
          return decide_identity(kind, known, agreements, given, engines);
        else if constexpr (std::is_same_v<Kind, DeriveClaim>)
          return decide_derive(kind, known, agreements, given, engines);
        else
          return decide_minimum(kind, known, agreements, given, engines);
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

}  // namespace

CaseResult verified(const Case& given, const VerificationOptions& options) {
  CaseResult result;
  result.verified = given;
  Derivations derivations;
  for (const Claim& claim : given.claims) {
    const bool wanted = !options.wanted || options.wanted(claim);
    if (!wanted && claim.verb != "derive") continue;
    if (wanted && options.progress) options.progress(claim);
    const auto start = std::chrono::steady_clock::now();
    ClaimResult decided_claim{claim, {}, {}, {}};
    decided_claim.decision = decide(decided_claim, derivations, given, options.engines);
    decided_claim.time = std::chrono::duration_cast<std::chrono::microseconds>(
        std::chrono::steady_clock::now() - start);
    const Decision& decision = decided_claim.decision;
    decided_claim.outcome = outcome_of(claim.expectation, decision.verdict);
    if (claim.verb == "derive") {
      const bool solved =
          decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
      derivations[claim.label][claim.instance] = {decision.solution, decision.conditions, solved};
    }
    if (wanted) result.claims.push_back(std::move(decided_claim));
  }
  for (const Shown& shown : given.shown) {
    ShownResult item{shown.span, shown.instance, "", "", std::nullopt};
    if (shown.joint) {
      item.joint = joint_report(*shown.joint, given.limits);
      item.value = in_words(*item.joint);
    } else {
      item.term = to_text(shown.term);
      item.value = normal_form_in_words(shown.term, given.limits);
    }
    result.shown.push_back(std::move(item));
  }
  return result;
}

}  // namespace patchproof
