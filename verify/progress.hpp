#pragma once

#include <chrono>
#include <string>

namespace patchproof {

/// One line on standard error that says how far a run is; erased at the end of its life.
///
/// Only where standard error is a terminal, and not more often than a person can read.
class Progress {
 public:
  explicit Progress(std::size_t total = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Goes on to the next claim.
  void next(const std::string& id);
  /// The same where more has been found to do.
  void next(const std::string& id, std::size_t total);

 private:
  std::size_t total_;
  std::size_t done_ = 0;
  bool terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace patchproof
