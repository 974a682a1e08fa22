#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <patchproof/mutation/mutation.hpp>
#include <patchproof/report/report.hpp>

namespace patchproof {

/// What became of the errors that were put into cases, in the order of the files and of their
/// texts.
struct MutationReport {
  std::vector<CaseMutation> cases;
  /// What could not be read. Their cases are empty.
  std::vector<FileReport> files;
  /// Also list the changes that say the same.
  bool verbose = false;
};

/// How many of the changes that have a meaning ended how.
struct MutationCount {
  std::size_t tried = 0;
  std::size_t noticed = 0;
  std::size_t unnoticed = 0;
  std::size_t same = 0;
  std::size_t undecided = 0;
  std::size_t internal = 0;
};
MutationCount count_of(const SiteMutants& site);
MutationCount count_of(const MutationReport& report);

/// What the program ends with: 0 when every error is noticed, 1 when one is not or a claim is wrong
/// without any, 2 when something was not decided, 5 when there was nothing to change.
ExitCode exit_code(const MutationReport& report);

/// The report in the format of the name, "text" or "json".
/// @throws std::invalid_argument when there is no such format.
std::string written(const MutationReport& report, std::string_view format);

/// The report for a person: for each claim and declaration what goes unnoticed there, for each case
/// what hides it and which data would not.
std::string text_of(const MutationReport& report);

/// The report as one JSON document, as described in docs/mutate.md.
std::string json_of(const MutationReport& report);

}  // namespace patchproof
