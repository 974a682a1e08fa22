#pragma once

#include <verify/work.hpp>

#include <functional>
#include <string>
#include <vector>

#include <patchproof/report/run_record.hpp>

namespace patchproof {

/// What came of the work.
struct WorkDone {
  RunRecord run;
  /// The patterns of the selection that no claim matches.
  std::vector<std::string> unmatched;
};

/// Called with each claim that is decided, and how many there are in the files read so far.
using WorkProgress = std::function<void(const std::string& id, std::size_t claims)>;

/// Lets up to `jobs` workers do the work. The record does not depend on their number, nor on who
/// was faster: only the times in it do.
///
/// A worker that dies or does not end costs the claim it worked on, which is unknown then; the
/// others of its claims are given to somebody else.
/// @throws std::system_error when no worker can be started.
/// @throws std::runtime_error when what has come in can no longer be stored.
WorkDone done_by_crew(const Work& work, std::size_t jobs, const WorkProgress& progress);

}  // namespace patchproof
