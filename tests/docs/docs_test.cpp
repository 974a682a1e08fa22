#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

struct Command {
  std::string text;
  std::string expected;
};

std::string text_of(const fs::path& path) {
  std::ifstream file{path};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// ```console blocks: "$ command" lines, each followed by what it prints (both streams). A last line
// "[exit 1]" is printed for exit codes other than 0. ```proof NAME blocks are files that the
// commands after them may read.
struct Document {
  std::vector<std::pair<std::string, std::string>> files;
  std::vector<Command> commands;
};

Document document(const std::string& text) {
  Document result;
  std::istringstream lines{text};
  std::string block;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("```", 0) == 0) {
      block = block.empty() ? line.substr(3) : "";
      if (block.rfind("proof ", 0) == 0) result.files.emplace_back(block.substr(6), "");
      continue;
    }
    if (block.rfind("proof ", 0) == 0) result.files.back().second += line + "\n";
    if (block != "console") continue;
    if (line.rfind("$ ", 0) == 0)
      result.commands.push_back({line.substr(2), ""});
    else if (!result.commands.empty())
      result.commands.back().expected += line + "\n";
  }
  return result;
}

std::string output_of(const std::string& command, const fs::path& folder) {
  const std::string bin = fs::path{PATCHPROOF_PROGRAM}.parent_path().string();
  const std::string line = "cd '" + folder.string() + "' && export PATH='" + bin + "':$PATH && { " +
                           command + "\n} 2>&1 </dev/null";
  FILE* pipe = popen(line.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string output;
  std::array<char, 4096> buffer{};
  while (std::size_t count = fread(buffer.data(), 1, buffer.size(), pipe))
    output.append(buffer.data(), count);
  const int status = pclose(pipe);
  if (status != 0) output += "[exit " + std::to_string(WEXITSTATUS(status)) + "]\n";
  return output;
}

}  // namespace

TEST_CASE("every command in the documents prints what they say") {
  const fs::path root{PATCHPROOF_SOURCE_FOLDER};
  std::vector<fs::path> documents{root / "README.md"};
  for (const auto& entry : fs::directory_iterator{root / "docs"})
    if (entry.path().extension() == ".md") documents.push_back(entry.path());
  std::sort(documents.begin(), documents.end());
  std::size_t count = 0;
  for (const fs::path& path : documents) {
    // Commands run in a folder of their own that sees the cases and the files of the document.
    const fs::path folder =
        fs::temp_directory_path() / ("patchproof-docs-" + std::to_string(getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder);
    fs::create_directory_symlink(root / "cases", folder / "cases");
    const Document found = document(text_of(path));
    for (const auto& [name, text] : found.files) std::ofstream{folder / name} << text;
    for (const Command& command : found.commands) {
      INFO(path.filename().string() << ": $ " << command.text);
      // make builds; its effect is tested by whoever runs the tests.
      if (command.text.rfind("make", 0) == 0) continue;
      CHECK(output_of(command.text, folder) == command.expected);
      ++count;
    }
    fs::remove_all(folder);
  }
  CHECK(count >= 10);
}
