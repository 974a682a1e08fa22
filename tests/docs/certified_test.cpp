#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <patchproof/language/reader.hpp>
#include <tests/cases/case_files.hpp>
#include <tests/docs/certified_table.hpp>

namespace patchproof::test {

namespace {

constexpr const char* page_path = PATCHPROOF_SOURCE_FOLDER "/docs/trust.md";
const std::string first_mark = "<!-- written by `make certified` -->\n";
const std::string last_mark = "<!-- end -->\n";

std::string text_of(const std::string& path) {
  std::ifstream file{path, std::ios::binary};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

CertifiedCounts counts_of_cases() {
  VerificationOptions options;
  options.engines = Engines::kernel;
  CertifiedCounts counts;
  for (const SourceText& source : case_files()) {
    const ReadFile file =
        read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
    for (const Case& given : file.cases) count_certified(verified(given, options), counts);
  }
  return counts;
}

}  // namespace

TEST_CASE("docs/trust.md says which claims of the cases have a certificate") {
  if (sanitized) {
    SUCCEED("it needs every case, which the other builds decide");
    return;
  }
  const std::string page = text_of(page_path);
  const std::size_t begin = page.find(first_mark);
  const std::size_t end = page.find(last_mark);
  REQUIRE(begin != std::string::npos);
  REQUIRE(end != std::string::npos);
  const std::string table = "\n" + certified_table(counts_of_cases()) + "\n";
  const std::size_t after = begin + first_mark.size();
  if (std::getenv("PATCHPROOF_WRITE_CERTIFIED") != nullptr) {
    std::ofstream{page_path, std::ios::binary} << page.substr(0, after) + table + page.substr(end);
    return;
  }
  CHECK(page.substr(after, end - after) == table);
}

}  // namespace patchproof::test
