#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <patchproof/net/segment_comparison.hpp>
#include <patchproof/net/segments.hpp>
#include <patchproof/report/report.hpp>

namespace patchproof {

/// What was found out about the Bézier segments of a net.
struct SegmentsReport {
  /// The name of its file.
  std::string net;
  std::size_t rows = 0;
  std::size_t columns = 0;
  KnotVector u;
  KnotVector v;
  SegmentShape shape;
  SegmentFindings findings;
  /// The file the segments were compared with; "" for none.
  std::string against;
  std::size_t different_points = 0;
  std::optional<SegmentDifference> first_difference;
};

/// One statement about the segments, and how it ended.
struct SegmentsClaim {
  /// "every net", "segments", "C^2 in u", "C^2 in v" or "against"
  std::string id;
  std::string statement;
  bool proved = false;
  /// What a proof is restricted to; "" for nothing.
  std::string remark;
  /// Of a refutation, its witness: names and values in their order.
  std::vector<std::pair<std::string, std::string>> witness;
};

/// All statements, in their order.
std::vector<SegmentsClaim> claims_of(const SegmentsReport& report);

/// What the program ends with: 0 when all is proved, 1 when something is refuted, 70 when the
/// segments made are not the surface.
ExitCode exit_code(const SegmentsReport& report);

/// The report in the format of the name, "text" or "json", see docs/nets.md.
/// @throws std::invalid_argument when there is no such format.
std::string written(const SegmentsReport& report, std::string_view format);

}  // namespace patchproof
