#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include <tests/cases/mutation.hpp>

namespace patchproof::test {

namespace {

// The files of tests/cases/survivors, one for each folder of cases/: "# why" lines explain the
// descriptions below them.
std::map<std::string, std::string> explained_survivors(const std::string& part) {
  std::map<std::string, std::string> result;
  for (const auto& entry :
       std::filesystem::directory_iterator{PATCHPROOF_SOURCE_FOLDER "/tests/cases/survivors"}) {
    if (("cases/" + entry.path().stem().string()).find(part) == std::string::npos) continue;
    std::ifstream file{entry.path()};
    std::string why;
    for (std::string line; std::getline(file, line);) {
      if (line.empty()) continue;
      if (line.front() == '#')
        why = line.substr(1);
      else
        result.emplace(line, why);
    }
  }
  return result;
}

// PATCHPROOF_MUTATE=cases/coons looks at that folder only, which is what its author wants to see.
std::string chosen_part() {
  const char* part = std::getenv("PATCHPROOF_MUTATE");
  return part == nullptr ? "" : part;
}

}  // namespace

// All changes take minutes under the sanitizers, which only have to see the code run.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t every = 40;
#else
constexpr std::size_t every = 1;
#endif

TEST_CASE("changing one sign, number, index or hypothesis of cases/ is noticed") {
  const std::map<std::string, std::string> explained = explained_survivors(chosen_part());
  std::size_t count = 0;
  std::size_t tried = 0;
  std::set<std::string> survivors;
  for (const SourceText& file : case_files(chosen_part())) {
    for (const SourceText& source : single_cases(file)) {
      for (const Mutation& mutation : mutations(source)) {
        if (++count % every != 0) continue;
        ++tried;
        if (!is_caught(source, mutation)) survivors.insert(mutation.description);
      }
    }
  }
  WARN(tried << " of " << count << " changes tried, " << survivors.size() << " not noticed");
  CHECK((!chosen_part().empty() || count >= 200));
  for (const std::string& survivor : survivors) {
    INFO("not noticed and not explained in tests/cases/survivors: " << survivor);
    CHECK(explained.count(survivor) == 1);
  }
  for (const auto& [description, why] : explained) {
    INFO("explained, but noticed after all or gone: " << description);
    CHECK((every > 1 || survivors.count(description) == 1));
    CHECK(!why.empty());
  }
}

}  // namespace patchproof::test
