#pragma once

#include <string>
#include <vector>

#include <recheck/recheck.hpp>

namespace recheck {

/// What a run prints, and its exit code: 4 when a file cannot be read, 1 when a certificate is
/// rejected, 2 when one cannot be judged, 5 when there is none, 0 when all are rechecked.
struct Run {
  std::string output;
  std::string errors;
  int code = 0;
};

/// Looks at the certificates in all files; "-" is standard input.
Run run_of(const std::vector<std::string>& paths, const Limits& limits = {});

}  // namespace recheck
