#include <patchproof/repair/candidate.hpp>

#include <algorithm>

namespace patchproof {

namespace {

/// What one look may cost: much less than a proof, because most candidates are false.
constexpr std::uint64_t most_steps_of_a_look = 20'000'000;

Limits of_a_look(Limits limits) {
  if (limits.steps == 0 || limits.steps > most_steps_of_a_look) limits.steps = most_steps_of_a_look;
  return limits;
}

}  // namespace

CandidateJudge::CandidateJudge(const syntax::Case& written, const syntax::Statement& claim,
                               const Case& given, const Library& library, Engines engines)
    : given_{given}, engines_{engines}, reader_{written, claim, library} {
  for (std::size_t k = 0; k < reader_.instances(); ++k)
    trials_.emplace_back(of_a_look(given.limits));
  for (const syntax::Binder& binder : claim.clauses.binders) running_.push_back(binder.name.text);
  const std::vector<syntax::Name>& labels = claim.clauses.using_labels;
  if (labels.empty()) return;
  Case derivations = given;
  derivations.shown.clear();
  derivations.claims = reader_.above();
  std::erase_if(derivations.claims, [](const Claim& c) { return c.verb != "derive"; });
  used_ = derivations.claims;
  VerificationOptions options;
  options.engines = Engines::kernel;
  for (const ClaimResult& result : verified(derivations, options).claims)
    solutions_[{result.claim.label, result.claim.instance}] = result.decision;
}

// The values that the derivations of the same instance, or of the one around it, hand on.
std::vector<KnownValue> CandidateJudge::known_to(const Claim& claim) const {
  std::vector<KnownValue> known;
  for (const std::string& label : claim.uses) {
    std::string instance = claim.instance;
    auto found = solutions_.find({label, instance});
    while (found == solutions_.end() && !instance.empty()) {
      const std::size_t comma = instance.rfind(',');
      instance = comma == std::string::npos ? "" : instance.substr(0, comma) + "]";
      found = solutions_.find({label, instance});
    }
    if (found == solutions_.end()) continue;
    const std::vector<KnownValue>& values = found->second.solution;
    known.insert(known.end(), values.begin(), values.end());
  }
  return known;
}

bool CandidateJudge::may_hold(const syntax::Proposition& proposition) {
  for (std::size_t k = 0; k < reader_.instances(); ++k) {
    const std::vector<Claim> claims = reader_.read(k, proposition);
    if (claims.empty()) return false;
    for (const Claim& claim : claims) {
      Goal goal = std::get<IdentityClaim>(claim.kind).goal;
      goal.known = known_to(claim);
      if (!trials_[k].may_hold(goal)) return false;
    }
  }
  return true;
}

CandidateJudge::Verdicts CandidateJudge::decided(const syntax::Proposition& proposition) {
  Case changed = given_;
  changed.shown.clear();
  changed.claims = used_;
  const std::size_t derivations = used_.size();
  for (std::size_t k = 0; k < reader_.instances(); ++k) {
    std::vector<Claim> claims = reader_.read(k, proposition);
    if (claims.empty()) return {};
    std::move(claims.begin(), claims.end(), std::back_inserter(changed.claims));
  }
  if (changed.claims.size() == derivations) return {};
  VerificationOptions options;
  options.engines = engines_;
  options.wanted = [](const Claim& claim) { return claim.verb != "derive"; };
  Verdicts result{Verdict::proved, Evidence::both_engines, {}};
  for (const ClaimResult& claim : verified(changed, options).claims) {
    const Decision& decision = claim.decision;
    if (decision.verdict != Verdict::proved && decision.verdict != Verdict::proved_if)
      return {decision.verdict, decision.evidence, {}};
    if (decision.verdict == Verdict::proved_if) result.verdict = Verdict::proved_if;
    if (decision.evidence != Evidence::both_engines) result.evidence = decision.evidence;
    for (const std::string& condition : decision.conditions)
      if (std::find(result.conditions.begin(), result.conditions.end(), condition) ==
          result.conditions.end())
        result.conditions.push_back(condition);
  }
  return result;
}

}  // namespace patchproof
