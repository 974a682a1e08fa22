#pragma once

// Internal to the JSON report.

#include <vector>

#include <patchproof/report/json_parts.hpp>

namespace patchproof {

/// Adds "audits", one for each case that was asked; nothing where none was.
void add_audits(const std::vector<FileReport>& files, Json& document);

}  // namespace patchproof
