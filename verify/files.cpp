#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <verify/files.hpp>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace patchproof {

namespace {

constexpr std::size_t block_size = std::size_t{1} << 16;

std::string system_words() { return std::strerror(errno); }

/// Closes a file descriptor at the end of its life.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_{value} {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  int value() const { return value_; }

 private:
  int value_;
};

FileText too_large(std::size_t megabytes) {
  return {std::nullopt, "larger than " + std::to_string(megabytes) + " MB"};
}

FileText all_of(int descriptor, std::size_t megabytes) {
  std::string text;
  std::string block(block_size, '\0');
  for (;;) {
    const ssize_t count = ::read(descriptor, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return {std::nullopt, system_words()};
    if (count == 0) return {std::move(text), ""};
    text.append(block, 0, static_cast<std::size_t>(count));
    if (text.size() > megabytes << 20U) return too_large(megabytes);
  }
}

}  // namespace

FileText file_text(const std::string& path, std::size_t megabytes) {
  // Without O_NONBLOCK, opening a pipe would wait for somebody to write into it.
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)};
  if (file.value() < 0) return {std::nullopt, system_words()};
  struct stat about {};
  if (::fstat(file.value(), &about) != 0) return {std::nullopt, system_words()};
  if (S_ISDIR(about.st_mode)) return {std::nullopt, std::strerror(EISDIR)};
  if (!S_ISREG(about.st_mode)) return {std::nullopt, "not a regular file"};
  if (about.st_size > static_cast<off_t>(megabytes << 20U)) return too_large(megabytes);
  return all_of(file.value(), megabytes);
}

FileText standard_input_text() { return all_of(STDIN_FILENO, usual_megabytes); }

std::string write_all(int descriptor, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(descriptor, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return system_words();
    done += static_cast<std::size_t>(count);
  }
  return "";
}

bool print(const std::string& text) {
  const std::string problem = write_all(STDOUT_FILENO, text);
  if (problem.empty()) return true;
  print_error("patchproof: cannot write standard output: " + problem + "\n");
  return false;
}

// When even this fails there is nobody left to tell.
void print_error(const std::string& text) { static_cast<void>(write_all(STDERR_FILENO, text)); }

namespace {

std::string new_file(const std::string& path, const std::string& text) {
  const Descriptor file{::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644)};
  return file.value() < 0 ? system_words() : write_all(file.value(), text);
}

}  // namespace

std::string replace_file(const std::string& path, const std::string& text) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  if (error == std::errc::no_such_file_or_directory) return new_file(path, text);
  if (error) return error.message();
  struct stat about {};
  if (::stat(target.c_str(), &about) != 0) return system_words();
  // The folder alone would allow it, but whoever made the file read-only meant it.
  if (::access(target.c_str(), W_OK) != 0) return system_words();
  std::string fresh =
      (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
  const Descriptor file{::mkstemp(fresh.data())};
  if (file.value() < 0) return system_words();
  std::string problem = write_all(file.value(), text);
  if (problem.empty() && ::fchmod(file.value(), about.st_mode & 07777U) != 0)
    problem = system_words();
  if (problem.empty() && ::fsync(file.value()) != 0) problem = system_words();
  if (problem.empty() && ::rename(fresh.c_str(), target.c_str()) != 0) problem = system_words();
  if (!problem.empty()) ::unlink(fresh.c_str());
  return problem;
}

}  // namespace patchproof
