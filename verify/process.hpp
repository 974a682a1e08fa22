#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

namespace patchproof {

/// Whether a program of that name can be found and run.
bool is_installed(const std::string& program);

/// A program that was started without a shell and without input, in a group of processes of its
/// own.
class Process {
 public:
  /// `output` is the file that gets its standard output and errors; "" for none. `folder` is where
  /// it works; "" for here.
  Process(const std::vector<std::string>& words, const std::string& folder,
          const std::string& output);
  /// Ends it if it still runs.
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  bool started() const { return child_ > 0; }
  /// Whether it has ended; if so `code` is its exit code, or -1 when a signal ended it.
  bool ended();
  int code() const { return code_; }
  std::chrono::steady_clock::duration age() const;
  /// Ends it and everything it has started.
  void kill();

 private:
  pid_t child_ = -1;
  bool running_ = false;
  int code_ = -1;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace patchproof
