#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <verify/files.hpp>
#include <verify/latex_run.hpp>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>
#include <thread>
#include <vector>

namespace patchproof {

namespace {

namespace fs = std::filesystem;

const char* const packages =
    "texlive-luatex texlive-latex-recommended texlive-pictures latexmk fonts-cmu "
    "texlive-lang-czechslovak texlive-lang-european texlive-lang-cyrillic";

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders{path == nullptr ? "" : path};
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path{folder} / program).c_str(), X_OK) == 0) return true;
  return false;
}

/// Starts latexmk in a group of processes of its own, with no input and no output.
pid_t started(const std::string& folder, const std::string& tex) {
  std::vector<std::string> words{"latexmk",          "-norc",
                                 "-lualatex",        "-interaction=nonstopmode",
                                 "-halt-on-error",   "-file-line-error",
                                 "-no-shell-escape", tex};
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = -1;
  if (::posix_spawnp(&child, "latexmk", &actions, &attributes, pointers.data(), environ) != 0)
    child = -1;
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return child;
}

/// The exit code; -1 when the time was up or a signal ended it.
int ended(pid_t child, std::chrono::seconds longest) {
  constexpr std::chrono::milliseconds pause{20};
  const auto end = std::chrono::steady_clock::now() + longest;
  int status = 0;
  for (;;) {
    const pid_t found = ::waitpid(child, &status, WNOHANG);
    if (found == child) return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (found < 0) return -1;
    if (std::chrono::steady_clock::now() > end) break;
    std::this_thread::sleep_for(pause);
  }
  // The group is ours alone: latexmk and what it has started.
  ::kill(-child, SIGKILL);
  ::waitpid(child, &status, 0);
  return -1;
}

}  // namespace

LatexError first_error(const std::string& log) {
  static const std::regex pattern{R"(^(.+?\.(?:tex|sty|aux|toc)):([0-9]{1,9}): (.*)$)"};
  std::istringstream lines{log};
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line.size() < 1000 && std::regex_match(line, match, pattern)) {
      std::string file = match[1].str();
      if (file.starts_with("./")) file = file.substr(2);
      return {file, std::stoul(match[2].str()), match[3].str()};
    }
    if (line.starts_with("! ")) return {"", 0, line.substr(2)};
  }
  return {};
}

std::string place_in_case(const std::string& tex, std::size_t line) {
  constexpr std::string_view mark = "% case ";
  std::istringstream lines{tex};
  std::string place;
  std::string text;
  for (std::size_t k = 1; k <= line && std::getline(lines, text); ++k)
    if (text.starts_with(mark)) place = text.substr(mark.size());
  return place;
}

LatexRun pdf_of(const std::string& folder, const std::string& tex, std::chrono::seconds longest) {
  for (const char* program : {"latexmk", "lualatex"})
    if (!is_installed(program))
      return {false, "cannot make a PDF: there is no '" + std::string{program} +
                         "'\n  = help: on Debian: apt-get install " + packages};
  const fs::path base = fs::path{folder} / fs::path{tex}.replace_extension();
  const std::string log_path = base.string() + ".log";
  std::error_code ignored;
  // What an earlier run said is not to be taken for what this one says.
  fs::remove(log_path, ignored);
  const pid_t child = started(folder, tex);
  if (child < 0) return {false, "cannot start latexmk"};
  const int code = ended(child, longest);
  if (code == 0) return {true, ""};
  std::string problem = "LaTeX failed on '" + (fs::path{folder} / tex).string() + "'";
  if (code == -1) problem += ": stopped after " + std::to_string(longest.count()) + " seconds";
  const LatexError error = first_error(file_text(log_path).text.value_or(""));
  if (!error.message.empty()) {
    problem += "\n  = error: ";
    if (!error.file.empty()) problem += error.file + ":" + std::to_string(error.line) + ": ";
    problem += error.message;
    const std::string place = place_in_case(
        file_text((fs::path{folder} / error.file).string()).text.value_or(""), error.line);
    if (!place.empty()) problem += "\n  = in the case: " + place;
  }
  return {false, problem + "\n  = log: " + log_path};
}

}  // namespace patchproof
