#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <patchproof/report/run_record.hpp>

namespace patchproof {

/// How much a text report tells.
enum class Verbosity {
  quiet,    ///< only what needs attention, and the summary
  normal,   ///< one line for each claim or family of claims as well
  verbose,  ///< every instance, with titles, evidence, witnesses and times
};

/// How a report is to look; a format may ignore what does not concern it.
struct ReportStyle {
  Verbosity verbosity = Verbosity::normal;
  /// With the colour codes of a terminal (ECMA-48).
  bool colour = false;
};

/// Takes a report piece by piece.
using ReportSink = std::function<void(std::string_view piece)>;

/// A way to write a report down.
struct Format {
  std::string_view name;
  void (*write)(const RunRecord& run, const ReportStyle& style, const ReportSink& sink);
};

/// All formats; the first is the usual one.
const std::vector<Format>& formats();

/// Writes the report in the format of the name. The same report always gives the same bytes.
/// @throws std::invalid_argument when there is no such format.
void write(const RunRecord& run, std::string_view format, const ReportStyle& style,
           const ReportSink& sink);
/// The same as one text.
std::string written(const RunRecord& run, std::string_view format, const ReportStyle& style);
std::string written(const Report& report, std::string_view format, const ReportStyle& style);

}  // namespace patchproof
