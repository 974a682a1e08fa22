#pragma once

#include <string>
#include <vector>

namespace patchproof {

/// Where a report goes: a file, or standard output. What goes wrong is said on standard error.
class Output {
 public:
  /// Opens the file; "" is standard output. A file that is one of the inputs is refused, and is
  /// left as it is.
  Output(const std::string& path, const std::vector<std::string>& inputs);
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  bool good() const { return descriptor_ >= 0; }
  /// Writes the text, all there will be. @returns whether that went well.
  bool write(const std::string& text);

 private:
  void complain(const std::string& problem) const;

  std::string path_;
  int descriptor_;
};

}  // namespace patchproof
