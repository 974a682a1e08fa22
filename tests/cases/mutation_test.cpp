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

// All changes take minutes under the sanitizers, which only have to see the code run.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t every = 40;
#else
constexpr std::size_t every = 1;
#endif

TEST_CASE("changing one sign, number or index of a true claim of cases/ is noticed") {
  const std::map<std::string, std::string> explained = explained_survivors();
  std::size_t count = 0;
  std::size_t tried = 0;
  std::set<std::string> survivors;
  for (const SourceText& file : case_files()) {
    for (const SourceText& source : single_cases(file)) {
      for (const Mutation& mutation : mutations(source)) {
        if (++count % every != 0) continue;
        ++tried;
        if (!is_caught(source, mutation)) survivors.insert(mutation.description);
      }
    }
  }
  WARN(tried << " of " << count << " changes tried, " << survivors.size() << " not noticed");
  CHECK(count >= 200);
  for (const std::string& survivor : survivors) {
    INFO("not noticed and not explained in survivors.txt: " << survivor);
    CHECK(explained.count(survivor) == 1);
  }
  for (const auto& [description, why] : explained) {
    INFO("explained, but noticed after all or gone: " << description);
    CHECK((every > 1 || survivors.count(description) == 1));
    CHECK(!why.empty());
  }
}

}  // namespace patchproof::test
