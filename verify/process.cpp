#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <verify/process.hpp>

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace patchproof {

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders{path == nullptr ? "" : path};
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((std::filesystem::path{folder} / program).c_str(), X_OK) == 0) return true;
  return false;
}

Process::Process(const std::vector<std::string>& words, const std::string& folder,
                 const std::string& output)
    : start_{std::chrono::steady_clock::now()} {
  std::vector<std::string> own = words;
  std::vector<char*> pointers;
  for (std::string& word : own) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const char* file = output.empty() ? "/dev/null" : output.c_str();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, file, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  if (!folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  if (::posix_spawnp(&child_, own.front().c_str(), &actions, &attributes, pointers.data(),
                     environ) != 0)
    child_ = -1;
  running_ = child_ > 0;
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
}

Process::~Process() { kill(); }

bool Process::ended() {
  if (!running_) return true;
  int status = 0;
  const pid_t found = ::waitpid(child_, &status, WNOHANG);
  if (found == 0) return false;
  running_ = false;
  if (found == child_) code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return true;
}

std::chrono::steady_clock::duration Process::age() const {
  return std::chrono::steady_clock::now() - start_;
}

void Process::kill() {
  if (!running_) return;
  // The group is ours alone: the program and what it has started.
  ::kill(-child_, SIGKILL);
  int status = 0;
  ::waitpid(child_, &status, 0);
  running_ = false;
  code_ = -1;
}

}  // namespace patchproof
