#pragma once

#include <chrono>
#include <string>

#include <patchproof/report/report.hpp>

namespace patchproof {

/// While it lives, the program ends by itself after some time, wherever it is then: with a text on
/// standard output, an exit code, and without a file that is only half written. There is one at a
/// time.
class Deadline {
 public:
  /// @param after no end when it is zero
  Deadline(std::chrono::seconds after, const std::string& text, ExitCode code);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  /// This file is not to stay; "" when none is to go any more.
  static void removes(const std::string& path);
};

}  // namespace patchproof
