#pragma once

#include <string>
#include <vector>

#include <patchproof/claims/verification.hpp>

namespace patchproof {

/// What a claim owes to one assumption.
enum class Need {
  unneeded,   ///< proved: the others suffice
  unrelated,  ///< refuted: the assumption speaks of other things
  kept,       ///< refuted: the claim is false even under it
  undecided,  ///< neither proved nor refuted
  needed,     ///< proved: the proof does not go through without it
  necessary,  ///< proved: false without it
};

/// "unneeded", "kept", …
std::string to_text(Need need);

/// One assumption as one claim sees it. Over the instances of a family: the strongest need.
struct AssumptionUse {
  /// The label; "assumption 3" where there is none.
  std::string name;
  Need need = Need::unneeded;
  /// Necessary: exact values at which the claim is false without it.
  WitnessReport witness;
};

/// The assumptions above one claim, in order.
struct ClaimAudit {
  std::string label;
  std::string verb;
  std::vector<AssumptionUse> uses;
};

/// What becomes of one assumption of a case.
struct AssumptionAudit {
  enum class Status {
    needed,     ///< by some proof
    kept,       ///< no proof needs it, but something false is false even under it
    noted,      ///< nothing needs it, and its author says why it is there
    undecided,  ///< some claim under it was not decided, or not looked at
    flagged,    ///< nothing needs it
  };
  std::string name;
  Span span;
  std::string note;
  Status status = Status::flagged;
  /// Labels of the claims that need it, and of those that are false under it.
  std::vector<std::string> needed_by;
  std::vector<std::string> kept_by;
};

/// "needed", "flagged", …
std::string to_text(AssumptionAudit::Status status);

/// What the assumptions of a case are for.
struct CaseAudit {
  std::string name;
  std::vector<ClaimAudit> claims;
  std::vector<AssumptionAudit> assumptions;
};

/// Decides each claim again with fewer assumptions, by the kernel. `result` is what was decided of
/// the case; where that is not every claim, no assumption is flagged.
CaseAudit audited(const Case& given, const CaseResult& result);

}  // namespace patchproof
