#pragma once

#include <string>

#include <patchproof/claims/audit.hpp>

namespace patchproof {

/// What the assumptions of one case are for, claim by claim and then assumption by assumption; what
/// is flagged last, with its place and what to do. Only that when `only_flagged`.
std::string audit_text(const CaseAudit& audit, bool only_flagged);

}  // namespace patchproof
