#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <set>

#include <tests/cases/mutation.hpp>

namespace patchproof::test {

namespace {

// tests/cases/survivors.txt: "# why" lines explain the descriptions below them.
std::map<std::string, std::string> explained_survivors() {
  std::ifstream file{PATCHPROOF_SOURCE_FOLDER "/tests/cases/survivors.txt"};
  std::map<std::string, std::string> result;
  std::string why;
  for (std::string line; std::getline(file, line);) {
    if (line.empty()) continue;
    if (line.front() == '#')
      why = line.substr(1);
    else
      result.emplace(line, why);
  }
  return result;
}

}  // namespace

TEST_CASE("changing one sign, number or index of a true claim of cases/ is noticed") {
  const std::map<std::string, std::string> explained = explained_survivors();
  std::size_t count = 0;
  std::set<std::string> survivors;
  for (const SourceText& source : case_files()) {
    for (const Mutation& mutation : mutations(source)) {
      ++count;
      if (!is_caught(source, mutation)) survivors.insert(mutation.description);
    }
  }
  WARN(count << " changes, " << survivors.size() << " not noticed, all explained in survivors.txt");
  CHECK(count >= 200);
  for (const std::string& survivor : survivors) {
    INFO(survivor);
    CHECK(explained.count(survivor) == 1);
  }
  for (const auto& [description, why] : explained) {
    INFO("explained, but noticed after all or gone: " << description);
    CHECK(survivors.count(description) == 1);
    CHECK(!why.empty());
  }
}

}  // namespace patchproof::test
