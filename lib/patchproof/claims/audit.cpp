#include <patchproof/claims/audit.hpp>

#include <algorithm>
#include <map>
#include <set>

#include <patchproof/claims/without_assumptions.hpp>

namespace patchproof {

std::string to_text(Need need) {
  switch (need) {
    case Need::unneeded:
      return "unneeded";
    case Need::unrelated:
      return "unrelated";
    case Need::kept:
      return "kept";
    case Need::undecided:
      return "undecided";
    case Need::needed:
      return "needed";
    default:
      return "necessary";
  }
}

std::string to_text(AssumptionAudit::Status status) {
  using Status = AssumptionAudit::Status;
  switch (status) {
    case Status::needed:
      return "needed";
    case Status::kept:
      return "kept";
    case Status::noted:
      return "noted";
    case Status::undecided:
      return "undecided";
    default:
      return "flagged";
  }
}

namespace {

bool is_proof(const Decision& decision) {
  return decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
}

// As good as before: the same verdict, and no condition that was not there.
bool as_good(const Decision& now, const Decision& before) {
  if (before.verdict == Verdict::inconsistent) return now.verdict == Verdict::inconsistent;
  return is_proof(now) &&
         std::all_of(now.conditions.begin(), now.conditions.end(), [&](const std::string& c) {
           return std::find(before.conditions.begin(), before.conditions.end(), c) !=
                  before.conditions.end();
         });
}

// Those left out by and by, the last first, as long as the proof goes through.
std::set<std::string> unneeded(const Case& given, const ClaimResult& result,
                               const std::vector<std::string>& names) {
  const auto holds_without = [&](const std::set<std::string>& removed) {
    return as_good(decided_without(given, result.claim, removed), result.decision);
  };
  const std::set<std::string> all{names.begin(), names.end()};
  if (holds_without(all)) return all;
  std::set<std::string> removed;
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    removed.insert(*name);
    if (!holds_without(removed)) removed.erase(*name);
  }
  return removed;
}

std::vector<AssumptionUse> uses_of(const Case& given, const ClaimResult& result) {
  const std::vector<std::string> names = assumption_names(result.claim);
  std::vector<AssumptionUse> uses;
  const Verdict verdict = result.decision.verdict;
  if (is_proof(result.decision) || verdict == Verdict::inconsistent) {
    const std::set<std::string> removed = unneeded(given, result, names);
    for (const std::string& name : names) {
      AssumptionUse& use = uses.emplace_back(AssumptionUse{name, Need::unneeded, {}});
      if (removed.contains(name)) continue;
      const Decision without = decided_without(given, result.claim, {name});
      const bool is_false = without.verdict == Verdict::refuted;
      use.need = is_false ? Need::necessary : Need::needed;
      if (is_false) use.witness = without.witness;
    }
    return uses;
  }
  const std::set<std::string> related = related_assumptions(given, result.claim);
  for (const std::string& name : names) {
    const Need need = verdict != Verdict::refuted ? Need::undecided
                      : related.contains(name)    ? Need::kept
                                                  : Need::unrelated;
    uses.push_back({name, need, {}});
  }
  return uses;
}

// Takes over what another instance of the family needs more.
void merge(const std::vector<AssumptionUse>& more, std::vector<AssumptionUse>& uses) {
  for (const AssumptionUse& use : more) {
    const auto same = std::find_if(uses.begin(), uses.end(),
                                   [&](const AssumptionUse& u) { return u.name == use.name; });
    if (same == uses.end())
      uses.push_back(use);
    else if (same->need < use.need)
      *same = use;
  }
}

std::vector<ClaimAudit> claim_audits(const Case& given, const CaseResult& result) {
  std::vector<ClaimAudit> audits;
  std::map<std::pair<std::size_t, std::string>, std::size_t> families;
  for (const ClaimResult& claim : result.claims) {
    const auto [place, fresh] =
        families.emplace(std::make_pair(claim.claim.span.begin, claim.claim.label), audits.size());
    if (fresh) audits.push_back({claim.claim.label, claim.claim.verb, {}});
    merge(uses_of(given, claim), audits[place->second].uses);
  }
  return audits;
}

AssumptionAudit assumption_audit(const std::string& name, const WrittenAssumption& written,
                                 const std::vector<ClaimAudit>& claims, bool all_decided) {
  using Status = AssumptionAudit::Status;
  AssumptionAudit audit{name, written.span, written.note, Status::flagged, {}, {}};
  bool undecided = !all_decided;
  for (const ClaimAudit& claim : claims) {
    for (const AssumptionUse& use : claim.uses) {
      if (use.name != name) continue;
      if (use.need >= Need::needed) audit.needed_by.push_back(claim.label);
      if (use.need == Need::kept) audit.kept_by.push_back(claim.label);
      undecided = undecided || use.need == Need::undecided;
    }
  }
  if (!audit.needed_by.empty())
    audit.status = Status::needed;
  else if (!audit.kept_by.empty())
    audit.status = Status::kept;
  else if (!audit.note.empty())
    audit.status = Status::noted;
  else if (undecided)
    audit.status = Status::undecided;
  return audit;
}

}  // namespace

CaseAudit audited(const Case& given, const CaseResult& result) {
  CaseAudit audit{given.name, claim_audits(given, result), {}};
  const bool all_decided = result.claims.size() == given.claims.size();
  for (const WrittenAssumption& written : given.assumptions) {
    for (std::size_t k = 0; k < written.count; ++k) {
      const std::string name = assumption_name(written.label, written.first + k);
      const auto same = std::find_if(audit.assumptions.begin(), audit.assumptions.end(),
                                     [&](const AssumptionAudit& a) { return a.name == name; });
      if (same == audit.assumptions.end())
        audit.assumptions.push_back(assumption_audit(name, written, audit.claims, all_decided));
    }
  }
  return audit;
}

}  // namespace patchproof
