#include <patchproof/language/prelude.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

using namespace patchproof;

TEST_CASE("The prelude in the library is byte for byte that of the files") {
  std::map<std::string, std::string> files;
  const std::filesystem::path folder{PATCHPROOF_SOURCE_FOLDER "/lib/patchproof/prelude"};
  for (const auto& entry : std::filesystem::directory_iterator{folder}) {
    std::ifstream stream{entry.path(), std::ios::binary};
    files[entry.path().filename().string()] = {std::istreambuf_iterator<char>{stream},
                                               std::istreambuf_iterator<char>{}};
  }
  REQUIRE_FALSE(files.empty());

  std::map<std::string, std::string> embedded;
  for (const auto& [name, text] : prelude_files()) embedded[std::string{name}] = text;
  CHECK(embedded == files);
  CHECK(std::is_sorted(prelude_files().begin(), prelude_files().end()));
}
