#pragma once

#include <string>
#include <string_view>
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
  bool write(std::string_view text);
  /// Writes a part of what there will be; `end` says whether that went well.
  void add(std::string_view piece);
  /// Writes what is not yet written. @returns whether everything went well.
  bool end();

 private:
  void flush();
  void complain(const std::string& problem) const;

  std::string path_;
  int descriptor_;
  std::string waiting_;
  /// Why nothing more is written.
  std::string problem_;
};

}  // namespace patchproof
