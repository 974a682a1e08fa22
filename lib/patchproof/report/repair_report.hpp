#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <patchproof/repair/repair.hpp>
#include <patchproof/report/report.hpp>

namespace patchproof {

/// What the search for repairs found, in the order of the files and of their texts.
struct RepairReport {
  std::vector<Repairs> statements;
  /// What could not be read. Their cases are empty.
  std::vector<FileReport> files;
};

/// What the program ends with: 0 when each false statement has a repair, 1 when one has none,
/// 2 when the search for one was stopped, 5 when no statement is false.
ExitCode exit_code(const RepairReport& report);

/// The report in the format of the name, "text" or "json".
/// @throws std::invalid_argument when there is no such format.
std::string written(const RepairReport& report, std::string_view format);

/// The report for a person: for each statement what is written, with a minus before it, and what
/// would be true, with a plus.
std::string text_of(const RepairReport& report);

/// The report as one JSON document, as described in docs/repair.md.
std::string json_of(const RepairReport& report);

}  // namespace patchproof
