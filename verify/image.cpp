#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <verify/files.hpp>
#include <verify/image.hpp>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

extern char** environ;

namespace patchproof {

namespace {

// A file without name: the converter reads it from its start, however slow it is.
int hidden_file(const std::string& text) {
  std::string name = (std::filesystem::temp_directory_path() / "patchproof_XXXXXX").string();
  const int descriptor = ::mkstemp(name.data());
  if (descriptor < 0) return descriptor;
  ::unlink(name.c_str());
  if (!write_all(descriptor, text).empty() || ::lseek(descriptor, 0, SEEK_SET) != 0) {
    ::close(descriptor);
    return -1;
  }
  return descriptor;
}

}  // namespace

std::string write_png(const std::string& svg, const std::string& path,
                      const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    std::error_code error;
    if (std::filesystem::equivalent(path, input, error) && !error)
      return "it is one of the case files";
  }
  const int target = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (target < 0) return std::strerror(errno);
  const int source = hidden_file(svg);
  if (source < 0) {
    ::close(target);
    return "no temporary file";
  }
  std::string program = "rsvg-convert";
  std::array<std::string, 5> words{program, "--dpi-x=300", "--dpi-y=300",
                                   "--background-color=white", "--format=png"};
  std::array<char*, 6> arguments{};
  for (std::size_t k = 0; k < words.size(); ++k) arguments[k] = words[k].data();
  // What is in the file is replaced only now: until here nothing was known to work.
  const bool emptied = ::ftruncate(target, 0) == 0;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, source, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, target, STDOUT_FILENO);
  pid_t child = 0;
  const int problem = emptied ? ::posix_spawnp(&child, program.c_str(), &actions, nullptr,
                                               arguments.data(), environ)
                              : errno;
  posix_spawn_file_actions_destroy(&actions);
  ::close(source);
  ::close(target);
  if (problem == ENOENT)
    return "there is no program rsvg-convert\n  = help: install the package librsvg2-bin, or write "
           "*.svg";
  if (problem != 0) return std::strerror(problem);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? "" : "rsvg-convert failed";
}

}  // namespace patchproof
