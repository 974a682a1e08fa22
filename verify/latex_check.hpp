#pragma once

#include <string>

#include <patchproof/report/report.hpp>

namespace patchproof {

/// Reads again the cases of all .tex files in a folder, as found from the current directory, and
/// lists the files that would be written otherwise now.
///
/// @returns `as_expected` when all are fresh, `wrong` when one is stale, `nothing_ran` when there
/// is no file of this program, `unreadable` when the folder or a file cannot be read.
ExitCode checked(const std::string& folder);

}  // namespace patchproof
