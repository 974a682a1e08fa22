#pragma once

#include <string>
#include <vector>

#include <patchproof/report/run_record.hpp>

namespace patchproof {

/// A JSON report of `patchproof check`, as read from a file.
struct ReadReport {
  /// For messages.
  std::string name;
  std::string version;
  RunRecord run;
};

/// Reads a report back. Titles of cases, times, and the lines of text below mistakes are not in it.
/// @throws std::invalid_argument when the text is no such report, with the reason.
ReadReport report_from_json(const std::string& name, const std::string& text);

/// Several reports as one.
struct MergedReport {
  RunRecord run;
  /// Why they are not the report of one run: "shard 2 of 4 is missing".
  std::vector<std::string> complaints;
};

/// Joins the reports of the shards of a run: the result is the report of the run without shards.
/// Reports that are not about shards are joined in the order given.
MergedReport merged(const std::vector<ReadReport>& reports);

}  // namespace patchproof
