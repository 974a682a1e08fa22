#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <verify/image.hpp>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

extern char** environ;

namespace patchproof {

namespace {

/// A file without name, removed at the end of its life. Unlike a pipe it never has to be waited
/// for.
class HiddenFile {
 public:
  HiddenFile() {
    std::string name = (std::filesystem::temp_directory_path() / "patchproof_XXXXXX").string();
    descriptor_ = ::mkstemp(name.data());
    if (descriptor_ >= 0) ::unlink(name.c_str());
  }
  ~HiddenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  HiddenFile(const HiddenFile&) = delete;
  HiddenFile& operator=(const HiddenFile&) = delete;

  int descriptor() const { return descriptor_; }
  bool rewind() const { return ::lseek(descriptor_, 0, SEEK_SET) == 0; }

  std::string text() const {
    std::string result;
    std::array<char, 65536> block{};
    for (;;) {
      const ssize_t count = ::read(descriptor_, block.data(), block.size());
      if (count <= 0) return result;
      result.append(block.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  int descriptor_;
};

}  // namespace

FileText png_of(const std::string& svg) {
  const HiddenFile source;
  const HiddenFile target;
  if (source.descriptor() < 0 || target.descriptor() < 0 ||
      !write_all(source.descriptor(), svg).empty() || !source.rewind())
    return {std::nullopt, "no temporary file can be written"};
  std::array<std::string, 5> words{"rsvg-convert", "--dpi-x=300", "--dpi-y=300",
                                   "--background-color=white", "--format=png"};
  std::array<char*, 6> arguments{};
  for (std::size_t k = 0; k < words.size(); ++k) arguments[k] = words[k].data();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, source.descriptor(), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, target.descriptor(), STDOUT_FILENO);
  pid_t child = 0;
  const int problem =
      ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem == ENOENT)
    return {std::nullopt,
            "there is no program rsvg-convert\n"
            "  = help: install the package librsvg2-bin, or write *.svg"};
  if (problem != 0) return {std::nullopt, std::strerror(problem)};
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !target.rewind())
    return {std::nullopt, "rsvg-convert failed"};
  return {target.text(), ""};
}

}  // namespace patchproof
