#pragma once

#include <verify/cache.hpp>
#include <verify/certified.hpp>
#include <verify/selection.hpp>
#include <verify/shard.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <patchproof/patchproof.hpp>

namespace patchproof {

/// What a run of `check` has to do; the same for all its processes.
struct Work {
  /// In the order of the report. Only standard input and what cannot be read is here already.
  std::vector<std::string> paths;
  std::map<std::size_t, Input> known;
  /// Without `wanted` and `progress`.
  CheckOptions options;
  Selection selection{std::vector<std::string>{}};
  Shard shard;
  /// What was certified before.
  std::optional<CheckedFolder> checked;
  /// Where single claims are looked up before they are decided.
  std::optional<Cache> cache;

  /// Whether the claims of a file belong together: nothing can be said of one without the others.
  bool whole_files() const { return options.audit || checked; }
};

/// What of a case is in the report of the run, and of this shard.
struct CaseShare {
  bool in_run = false;
  bool in_shard = false;
  /// How many of its claims are in the run.
  std::size_t claims = 0;
};

/// A part of the work: of the things to be done with one file, those from `first` until `end`. They
/// are its claims, what it shows, and what is to be said of its cases, in this order.
struct Task {
  /// No two tasks of a run have the same one.
  std::size_t number = 0;
  std::size_t file = 0;
  std::size_t first = 0;
  std::size_t end = static_cast<std::size_t>(-1);
  /// What somebody was lost over, and how: it is not tried again.
  std::map<std::size_t, std::string> lost;
};

/// Text and name of the file.
Input input_of(const Work& work, std::size_t file);

}  // namespace patchproof
