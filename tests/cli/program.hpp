#pragma once

#include <string>
#include <vector>

namespace patchproof {

/// A fresh folder, removed with all that is in it at the end of its life.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// The path of something in the folder.
  std::string path(const std::string& name) const { return path_ + "/" + name; }
  /// Writes a file, and the folders it is in.
  void write(const std::string& name, const std::string& text) const;
  std::string text(const std::string& name) const;

 private:
  std::string path_;
};

/// How a run of the program ended.
struct Ended {
  /// The exit code; -1 when a signal ended the program.
  int code = -1;
  std::string output;
  std::string errors;
};

/// Runs the program in a folder, without a shell; `output_path` takes the place of a file for its
/// standard output.
Ended run_program(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                  const std::string& input = "", const std::string& output_path = "");

}  // namespace patchproof
