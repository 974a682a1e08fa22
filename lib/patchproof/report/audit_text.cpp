#include <patchproof/report/audit_text.hpp>

#include <algorithm>

#include <patchproof/language/utf8.hpp>
#include <patchproof/report/excerpt.hpp>
#include <patchproof/report/verdict_words.hpp>

namespace patchproof {

namespace {

using Status = AssumptionAudit::Status;

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

// "corners necessary, slopes unneeded"
std::string needs_of(const ClaimAudit& claim) {
  std::string text;
  for (const AssumptionUse& use : claim.uses)
    text += (text.empty() ? "" : ", ") + use.name + " " + to_text(use.need);
  return text;
}

void claim_lines(const CaseAudit& audit, std::string& text) {
  std::size_t width = 0;
  for (const ClaimAudit& claim : audit.claims)
    if (!claim.uses.empty()) width = std::max(width, claim.label.size());
  for (const ClaimAudit& claim : audit.claims) {
    if (claim.uses.empty()) continue;
    text += "  " + claim.label + std::string(width - claim.label.size() + 2, ' ') +
            needs_of(claim) + "\n";
    for (const AssumptionUse& use : claim.uses)
      if (use.need == Need::necessary)
        text += "      without " + use.name + " false for " + in_words(use.witness) +
                ": left side " + use.witness.left + ", right side " + use.witness.right + "\n";
  }
}

std::string fate_of(const AssumptionAudit& assumption) {
  switch (assumption.status) {
    case Status::needed:
      return "needed by " + joined(assumption.needed_by);
    case Status::kept:
      return "stays: refuted even under it, which says more: " + joined(assumption.kept_by);
    case Status::noted:
      return "stays: " + printable(assumption.note);
    case Status::undecided:
      return "claims that were not decided here may need it";
    default:
      return "flagged";
  }
}

void flagged_lines(const CaseAudit& audit, std::string& text) {
  for (const AssumptionAudit& assumption : audit.assumptions) {
    if (assumption.status != Status::flagged) continue;
    const std::string place = place_of(assumption.span);
    if (!text.empty()) text += "\n";
    text += (place.empty() ? "" : place + ": ") + audit.name + ": nothing needs '" +
            assumption.name + "'\n" + excerpt_of(assumption.span) +
            "       = help: leave it out, or say why it stays: assume ... note \"why\"\n";
  }
}

}  // namespace

std::string audit_text(const CaseAudit& audit, bool only_flagged) {
  std::string text;
  if (!only_flagged) {
    text = "assumptions of " + audit.name + "\n";
    claim_lines(audit, text);
    for (const AssumptionAudit& assumption : audit.assumptions)
      text += "  = " + assumption.name + ": " + fate_of(assumption) + "\n";
  }
  flagged_lines(audit, text);
  return text;
}

}  // namespace patchproof
