#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include <patchproof/language/reader.hpp>
#include <tests/cases/case_files.hpp>
#include <tests/docs/claims_page.hpp>

namespace patchproof::test {

namespace {

constexpr const char* page_path = PATCHPROOF_SOURCE_FOLDER "/docs/claims.md";

std::string text_of(const std::string& path) {
  std::ifstream file{path, std::ios::binary};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// Decided by the kernel alone: the test of the cases asks both engines.
Results decided_cases() {
  VerificationOptions options;
  options.engines = Engines::kernel;
  Results results;
  for (const SourceText& source : case_files()) {
    const ReadFile file =
        read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
    for (const Case& given : file.cases) results[given.name] = verified(given, options).claims;
  }
  return results;
}

}  // namespace

TEST_CASE("docs/claims.md has a row for every item of the notes, with the verdicts of the cases") {
  if (sanitized) {
    SUCCEED("it needs every case, which the other builds decide");
    return;
  }
  const std::vector<Item> items = items_of(text_of(PATCHPROOF_SOURCE_FOLDER "/cases/items.tsv"));
  const Results results = decided_cases();
  std::set<std::string> ids;
  std::set<std::string> covered;
  bool faultless = true;
  for (const Item& item : items) {
    const std::string fault = fault_of(item, results);
    INFO(item.id << ": " << fault);
    CHECK(fault.empty());
    faultless = faultless && fault.empty();
    CHECK(ids.insert(item.id).second);
    covered.insert(item.cases.begin(), item.cases.end());
  }
  CHECK(ids.size() == 147);
  for (const auto& [name, claims] : results) {
    INFO("belongs to no item: " << name);
    CHECK(covered.contains(name));
  }
  if (!faultless) return;
  const std::string page = claims_page(items, results);
  // `make claims` sets this.
  if (std::getenv("PATCHPROOF_WRITE_CLAIMS") != nullptr)
    std::ofstream{page_path, std::ios::binary} << page;
  const bool up_to_date = page == text_of(page_path);
  INFO("run 'make claims' and read the difference");
  CHECK(up_to_date);
}

TEST_CASE("[reject] an item whose verdicts do not add up is found") {
  Item item{"a.b", "sk", "1", "OVERCLAIM", "everything is true", {"a.b"}, ""};
  CHECK(fault_of(item, {}) == "there is no case 'a.b'");
  ClaimResult proved;
  proved.claim.label = "one";
  proved.decision.verdict = Verdict::proved;
  proved.outcome = Outcome::as_expected;
  CHECK(fault_of(item, {{"a.b", {proved}}}) == "nothing is refuted");
  item.verdict = "FALSE-AS-PRINTED";
  CHECK(fault_of(item, {{"a.b", {proved}}}) == "no erratum");
  item.verdict = "TRUE";
  CHECK(fault_of(item, {{"a.b", {proved}}}).empty());
  CHECK(claims_page({item}, {{"a.b", {proved}}}).find("`a.b`: proved one |") != std::string::npos);
  proved.outcome = Outcome::wrong;
  CHECK(fault_of(item, {{"a.b", {proved}}}) == "a claim is not decided as expected");
  item.document = "xx";
  CHECK(fault_of(item, {{"a.b", {proved}}}) == "the document 'xx' is not known");
  CHECK_THROWS_WITH(items_of("header\na\tb\n"), "line 2 has 2 columns, not 6");
}

}  // namespace patchproof::test
