#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <patchproof/latex/document.hpp>
#include <patchproof/patchproof.hpp>

namespace patchproof {

namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path{PATCHPROOF_SOURCE_FOLDER} / "tests/golden/latex";

std::string text_of(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<fs::path> files_with(const std::string& extension) {
  std::vector<fs::path> result;
  for (const auto& entry : fs::directory_iterator{folder})
    if (entry.path().extension() == extension) result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

// The digest and the version change with every definition and every release; here they are words.
std::string typeset(const fs::path& path) {
  const Report report = check({{path.filename().string(), text_of(path), ""}});
  const FileReport& file = report.files.front();
  INFO(path);
  REQUIRE(file.diagnostics.empty());
  REQUIRE(file.cases.size() == 1);
  const CaseResult& result = file.cases.front();
  for (const ClaimResult& claim : result.claims) {
    INFO(claim.claim.label);
    CHECK(claim.outcome == Outcome::as_expected);
  }
  const Page page{result, case_derivation(result, Detail::steps, Engines::both), {}, "DIGEST"};
  std::string tex = document(page, {});
  const std::string number{version};
  const std::size_t at = tex.find(number);
  if (at < tex.find('\n')) tex.replace(at, number.size(), "VERSION");
  return tex;
}

bool writes_anew() { return std::getenv("PATCHPROOF_WRITE_GOLDEN") != nullptr; }

}  // namespace

TEST_CASE("the documents of small cases are those of tests/golden/latex", "[golden]") {
  const std::vector<fs::path> sources = files_with(".proof");
  CHECK(sources.size() >= 12);
  for (const fs::path& source : sources) {
    const std::string tex = typeset(source);
    INFO(source);
    CHECK(typeset(source) == tex);
    fs::path golden = source;
    golden.replace_extension(".tex");
    if (writes_anew()) std::ofstream{golden, std::ios::binary} << tex;
    CHECK(tex == text_of(golden));
  }
}

TEST_CASE("every golden document has its case", "[golden]") {
  for (fs::path golden : files_with(".tex")) {
    INFO(golden);
    CHECK(fs::exists(golden.replace_extension(".proof")));
  }
}

}  // namespace patchproof
