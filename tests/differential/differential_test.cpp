#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>

#include "opinion.hpp"
#include "shrinking.hpp"

namespace patchproof::differential {
namespace {

/// A number that the environment may give.
std::uint64_t from_environment(const char* name, std::uint64_t usual) {
  const char* text = std::getenv(name);
  return text == nullptr ? usual : std::stoull(text);
}

Example example_from(const std::vector<std::uint64_t>& decisions) {
  Choices choices{decisions};
  return random_example(choices);
}

/// The smallest case found that has the same fault, and the reason given for its verdict.
std::string smallest_case(const std::vector<std::uint64_t>& decisions, const std::string& fault) {
  const Example smallest = example_from(
      shrunk(decisions, decisions_kept, 2000, [&](const std::vector<std::uint64_t>& fewer) {
        return judged(example_from(fewer)).fault == fault;
      }));
  return case_of(smallest) + judged(smallest).reason;
}

/// How often each verdict was given, by subject; UNKNOWN with its reasons.
using Table = std::map<std::string, std::map<std::string, std::uint64_t>>;

void write(const Table& table) {
  for (const auto& [sort, verdicts] : table)
    for (const auto& [verdict, times] : verdicts)
      std::cout << sort << ": " << times << " " << verdict << "\n";
}

}  // namespace

// PATCHPROOF_CLAIMS and PATCHPROOF_CLAIMS_FROM say how many and from which seed on, then the table
// of verdicts is written out; PATCHPROOF_CLAIMS_TO names a file for all cases.
TEST_CASE("random true claims are proved, near misses refuted, and every opinion is the same",
          "[law]") {
  const std::uint64_t count = from_environment("PATCHPROOF_CLAIMS", 500);
  const std::uint64_t first = from_environment("PATCHPROOF_CLAIMS_FROM", 1);
  Table table;
  std::uint64_t unknown = 0;
  std::vector<Example> examples;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    Choices choices{seed};
    examples.push_back(random_example(choices));
    const Example& example = examples.back();
    const Judgement judgement = judged(example);
    const bool undecided = judgement.verdict == "UNKNOWN";
    unknown += undecided;
    const std::string reason = undecided ? " (" + judgement.reason + ")" : "";
    ++table[example.subject + (example.holds ? ", true" : ", near miss")]
           [judgement.verdict + reason];
    if (judgement.fault.empty()) continue;
    FAIL_CHECK("seed " << seed << ": " << judgement.fault << "\n"
                       << case_of(example) << "smallest:\n"
                       << smallest_case(choices.made(), judgement.fault));
  }
  CHECK(unknown <= count / 100);
  CHECK((count < 500 || table.size() == 2 * subjects().size()));

  const std::vector<std::optional<bool>> opinions = opinions_of_python(examples);
  for (std::size_t i = 0; i < examples.size(); ++i) {
    if (!opinions[i] || *opinions[i] == examples[i].holds) continue;
    FAIL_CHECK("seed " << first + i << ": SymPy finds both sides "
                       << (*opinions[i] ? "equal" : "different") << "\n"
                       << case_of(examples[i]));
  }
  if (std::getenv("PATCHPROOF_CLAIMS") != nullptr) write(table);
  if (const char* path = std::getenv("PATCHPROOF_CLAIMS_TO")) {
    std::ofstream file{path};
    for (std::size_t i = 0; i < examples.size(); ++i)
      if (examples[i].holds || examples[i].subject != "derive")  // "refute derive" is no verb
        file << case_of(examples[i], "random.seed_" + std::to_string(first + i)) << "\n";
  }
}

}  // namespace patchproof::differential
