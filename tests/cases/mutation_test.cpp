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
// descriptions below them. "sk.a.b: *" stands for all changes of one statement: where a claim is
// about any data, no change of the data it is shown for is noticed.
std::map<std::string, std::string> explained_survivors(const std::string& part) {
  std::map<std::string, std::string> result;
  for (const auto& entry :
       std::filesystem::directory_iterator{PATCHPROOF_SOURCE_FOLDER "/tests/cases/survivors"}) {
    if (("cases/" + entry.path().stem().string() + "/").find(part) == std::string::npos) continue;
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

bool is_explained(const std::string& survivor, const std::map<std::string, std::string>& explained) {
  const std::string statement = survivor.substr(0, survivor.find(": "));
  return explained.contains(survivor) || explained.contains(statement + ": *");
}

bool is_met(const std::string& description, const std::set<std::string>& survivors) {
  if (description.back() != '*') return survivors.contains(description);
  const std::string start = description.substr(0, description.size() - 1);
  const auto first = survivors.lower_bound(start);
  return first != survivors.end() && first->rfind(start, 0) == 0;
}

// PATCHPROOF_MUTATE=cases/coons/ looks at that folder only: CTest runs them side by side.
std::string chosen_part() {
  const char* part = std::getenv("PATCHPROOF_MUTATE");
  return part == nullptr ? "" : part;
}

}  // namespace

constexpr std::size_t every = sanitized ? 200 : 1;

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
  CHECK(count > 0);
  for (const std::string& survivor : survivors) {
    INFO("not noticed and not explained in tests/cases/survivors: " << survivor);
    CHECK(is_explained(survivor, explained));
  }
  for (const auto& [description, why] : explained) {
    INFO("explained, but noticed after all or gone: " << description);
    CHECK((every > 1 || is_met(description, survivors)));
    CHECK(!why.empty());
  }
}

}  // namespace patchproof::test
