#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "program.hpp"

namespace patchproof {

namespace {

/// What stands between two marks of a text, the first time.
std::string between(const std::string& text, const std::string& first, const std::string& last) {
  const std::size_t begin = text.find(first);
  REQUIRE(begin != std::string::npos);
  const std::size_t inside = begin + first.size();
  const std::size_t end = text.find(last, inside);
  REQUIRE(end != std::string::npos);
  return text.substr(inside, end - inside);
}

}  // namespace

TEST_CASE("The example in docs/json.md is what the program prints") {
  std::ifstream file{PATCHPROOF_SOURCE_FOLDER "/docs/json.md"};
  const std::string page{std::istreambuf_iterator<char>{file}, {}};
  const TemporaryFolder folder;
  folder.write("squares.proof", between(page, "```\n", "```\n"));
  const Ended ended = run_program(folder, {"check", "squares.proof", "--format", "json"});
  CHECK(ended.errors == "");
  CHECK(ended.code == 0);
  CHECK(ended.output == between(page, "```json\n", "```\n"));
}

}  // namespace patchproof
