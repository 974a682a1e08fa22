#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include <patchproof/net/byte_reader.hpp>

namespace patchproof {

/// Thrown when a file cannot be read, or is larger than it may be; in the words of the system.
class UnreadableFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown when a file cannot be written, in the words of the system.
class UnwritableFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A regular file, or standard input for "-", block by block, so that only one block of it is in
/// memory. Devices and pipes other than standard input are refused, and more than so many
/// megabytes. The source throws UnreadableFile.
ByteSource file_blocks(const std::string& path, std::size_t megabytes);

/// A file that is written part by part. Only once it is finished it stands under its name: there is
/// never half a file. What is no regular file, such as a pipe, is written into at once.
class FileInParts {
 public:
  /// @throws UnwritableFile when no file can be made beside `path`.
  explicit FileInParts(const std::string& path);
  /// Without `finish`, nothing remains.
  ~FileInParts();
  FileInParts(const FileInParts&) = delete;
  FileInParts& operator=(const FileInParts&) = delete;

  /// @throws UnwritableFile
  void write(const std::string& text);
  /// Gives the file its name. @throws UnwritableFile
  void finish();

 private:
  std::string path_;
  /// Beside it; "" where there is none.
  std::string fresh_;
  int descriptor_ = -1;
};

}  // namespace patchproof
