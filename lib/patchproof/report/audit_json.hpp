#pragma once

// Internal to the JSON report.

#include <vector>

#include <patchproof/report/json_parts.hpp>

namespace patchproof {

Json to_json(const CaseAudit& audit);

}  // namespace patchproof
