#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <verify/deadline.hpp>
#include <verify/file_blocks.hpp>
#include <verify/files.hpp>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

namespace patchproof {

namespace {

constexpr std::size_t block_size = std::size_t{1} << 20;

[[noreturn]] void fail() { throw UnreadableFile{std::strerror(errno)}; }

/// An open file with room for one block.
class Blocks {
 public:
  Blocks(const std::string& path, std::size_t megabytes)
      : most_{megabytes << 20U}, megabytes_{megabytes}, block_(block_size) {
    if (path == "-") return;
    // Without O_NONBLOCK, opening a pipe would wait for somebody to write into it.
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor_ < 0) fail();
    try {
      require_regular();
    } catch (...) {
      ::close(descriptor_);
      throw;
    }
  }
  ~Blocks() {
    if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
  }
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;

  std::string_view next() {
    for (;;) {
      const ssize_t count = ::read(descriptor_, block_.data(), block_.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail();
      read_ += static_cast<std::size_t>(count);
      if (read_ > most_) fail_as_large();
      return {block_.data(), static_cast<std::size_t>(count)};
    }
  }

 private:
  void require_regular() const {
    struct stat about {};
    if (::fstat(descriptor_, &about) != 0) fail();
    if (S_ISDIR(about.st_mode)) throw UnreadableFile{std::strerror(EISDIR)};
    if (!S_ISREG(about.st_mode)) throw UnreadableFile{"not a regular file"};
    if (about.st_size > static_cast<off_t>(most_)) fail_as_large();
  }
  [[noreturn]] void fail_as_large() const {
    throw UnreadableFile{"larger than " + std::to_string(megabytes_) + " MB"};
  }

  int descriptor_ = STDIN_FILENO;
  std::size_t most_;
  std::size_t megabytes_;
  std::size_t read_ = 0;
  std::vector<char> block_;
};

}  // namespace

ByteSource file_blocks(const std::string& path, std::size_t megabytes) {
  return [blocks = std::make_shared<Blocks>(path, megabytes)] { return blocks->next(); };
}

// A device, a pipe or an open file of this process cannot be replaced by another file; a link is
// to stay a link.
FileInParts::FileInParts(const std::string& path) : path_{path} {
  struct stat about {};
  const bool exists = ::stat(path.c_str(), &about) == 0;
  const bool special = path.starts_with("/dev/") || path.starts_with("/proc/");
  if (exists && (special || !S_ISREG(about.st_mode))) {
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (descriptor_ < 0) throw UnwritableFile{std::strerror(errno)};
    return;
  }
  // The folder alone would allow it, but whoever made the file read-only meant it.
  if (exists && ::access(path.c_str(), W_OK) != 0) throw UnwritableFile{std::strerror(errno)};
  std::error_code error;
  if (exists) path_ = std::filesystem::canonical(path, error).string();
  if (error) throw UnwritableFile{error.message()};
  const std::filesystem::path target{path_};
  fresh_ = (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
  descriptor_ = ::mkstemp(fresh_.data());
  if (descriptor_ < 0) throw UnwritableFile{std::strerror(errno)};
  Deadline::removes(fresh_);
}

FileInParts::~FileInParts() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (fresh_.empty()) return;
  Deadline::removes("");
  ::unlink(fresh_.c_str());
}

void FileInParts::write(const std::string& text) {
  const std::string problem = write_all(descriptor_, text);
  if (!problem.empty()) throw UnwritableFile{problem};
}

void FileInParts::finish() {
  if (fresh_.empty()) {
    // Some file systems say only now that there was no room.
    if (::close(std::exchange(descriptor_, -1)) != 0) throw UnwritableFile{std::strerror(errno)};
    return;
  }
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(descriptor_, 0666U & ~mask) != 0) throw UnwritableFile{std::strerror(errno)};
  const int descriptor = std::exchange(descriptor_, -1);
  Deadline::removes("");
  if (::close(descriptor) == 0 && ::rename(fresh_.c_str(), path_.c_str()) == 0) return;
  const int problem = errno;
  ::unlink(fresh_.c_str());
  throw UnwritableFile{std::strerror(problem)};
}

}  // namespace patchproof
