#pragma once

// Internal to the reports: claims and shown terms as JSON values, as described in docs/json.md, and
// back again.

#include <patchproof/report/json_parts.hpp>
#include <patchproof/report/record.hpp>

namespace patchproof {

Json to_json(const ClaimRecord& claim, const std::string& of);
/// @throws std::exception when the value is not what `to_json` makes of a claim.
ClaimRecord claim_from(const Json& object);

Json to_json(const ShownRecord& shown, const std::string& of);
/// @throws std::exception when the value is not what `to_json` makes of a shown term.
ShownRecord shown_from(const Json& object);

Json to_json(const DiagnosticRecord& diagnostic);
/// Its text is what can be said without the file.
/// @throws std::exception when the value is not what `to_json` makes of a mistake.
DiagnosticRecord diagnostic_from(const Json& object);

}  // namespace patchproof
