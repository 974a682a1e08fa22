#pragma once

#include <string>

#include <patchproof/report/formats.hpp>

namespace patchproof {

/// The report for a person: one line for each claim or family of claims, then everything about
/// those that need attention, then a line of numbers.
///
/// What is wrong with the texts themselves is not in it: `mistakes` has that.
void text_report(const RunRecord& run, const ReportStyle& style, const ReportSink& sink);

/// What is wrong with the files of the report, one message after the other:
/// "patchproof: cannot read 'a.proof': No such file or directory", "a.proof:3:24: error: …".
std::string mistakes(const RunRecord& run);
std::string mistakes(const Report& report);

}  // namespace patchproof
