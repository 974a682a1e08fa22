#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file{path};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// A block "```coq CASE": paragraphs of the file that `patchproof certify` writes for the case.
struct Statements {
  std::string case_name;
  std::vector<std::string> paragraphs;
};

std::vector<Statements> statements(const std::string& text) {
  std::vector<Statements> result;
  std::istringstream lines{text};
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("```", 0) == 0) {
      inside = line.rfind("```coq ", 0) == 0;
      if (inside) result.push_back({line.substr(7), {""}});
    } else if (inside && line.empty()) {
      result.back().paragraphs.emplace_back();
    } else if (inside) {
      result.back().paragraphs.back() += line + "\n";
    }
  }
  return result;
}

// The file of cases in which the case stands.
std::string file_of(const std::string& case_name) {
  for (const auto& entry :
       fs::recursive_directory_iterator{fs::path{PATCHPROOF_SOURCE_FOLDER} / "cases"})
    if (entry.path().extension() == ".proof" &&
        text_of(entry.path()).find("case " + case_name + "\n") != std::string::npos)
      return entry.path().string();
  return "";
}

}  // namespace

TEST_CASE("the statements that docs/certify.md shows are those of the written files") {
  const fs::path root{PATCHPROOF_SOURCE_FOLDER};
  const fs::path folder =
      fs::temp_directory_path() / ("patchproof-statements-" + std::to_string(getpid()));
  const std::vector<Statements> shown = statements(text_of(root / "docs" / "certify.md"));
  CHECK(shown.size() == 5);
  for (const Statements& block : shown) {
    INFO(block.case_name);
    fs::remove_all(folder);
    const std::string command = "'" PATCHPROOF_PROGRAM "' certify '" + file_of(block.case_name) +
                                "' -o '" + folder.string() + "' >/dev/null 2>&1";
    REQUIRE(std::system(command.c_str()) == 0);
    std::string name = block.case_name;
    std::replace(name.begin(), name.end(), '.', '_');
    const std::string written = text_of(folder / (name + ".v"));
    for (const std::string& paragraph : block.paragraphs) {
      INFO(paragraph);
      // Whole lines: it begins where a line begins, and it ends with one.
      CHECK(("\n" + written).find("\n" + paragraph) != std::string::npos);
    }
  }
  fs::remove_all(folder);
}
