#pragma once

#include <patchproof/report/formats.hpp>

namespace patchproof {

/// The report as one JSON document, as described in docs/json.md; no times, so that two runs give
/// the same bytes. Bytes that are not valid UTF-8 become U+FFFD.
void json_report(const RunRecord& run, const ReportStyle& style, const ReportSink& sink);

}  // namespace patchproof
