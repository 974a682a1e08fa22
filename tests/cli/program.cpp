#include "program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace patchproof {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "patchproof_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error{"no temporary folder"};
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories(std::filesystem::path{path(name)}.parent_path());
  std::ofstream{path(name), std::ios::binary} << text;
}

std::string TemporaryFolder::text(const std::string& name) const {
  std::ifstream file{path(name), std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

Ended run_program(const TemporaryFolder& folder, const std::vector<std::string>& arguments,
                  const std::string& input, const std::string& output_path) {
  // What is passed in and out lies in a folder of its own, where the program does not look.
  const TemporaryFolder passed;
  passed.write("input", input);
  const std::string output = output_path.empty() ? passed.path("output") : output_path;

  std::vector<std::string> words{PATCHPROOF_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, passed.path("input").c_str(), O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, 2, passed.path("errors").c_str(), O_WRONLY | O_CREAT,
                                   0600);
  posix_spawn_file_actions_addchdir_np(&actions, folder.path("").c_str());
  pid_t child = 0;
  const int problem =
      ::posix_spawn(&child, words.front().c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0) throw std::runtime_error{"cannot start " + words.front()};

  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
  }
  Ended ended;
  if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
  if (output_path.empty()) ended.output = passed.text("output");
  ended.errors = passed.text("errors");
  return ended;
}

}  // namespace patchproof
