#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

#include <patchproof/derivation/case_derivation.hpp>
#include <patchproof/language/reader.hpp>
#include <patchproof/term/plain_text.hpp>
#include <tests/cases/case_files.hpp>

namespace patchproof::test {

namespace {

constexpr const char* exceptions_path = PATCHPROOF_SOURCE_FOLDER "/tests/derivation/exceptions.txt";

// The lines of the file that hold an exception of the folder, of all folders for "".
std::string expected_exceptions(const std::string& folder) {
  std::string result;
  std::ifstream file{exceptions_path};
  for (std::string line; std::getline(file, line);)
    if (!line.empty() && line.front() != '#' && line.rfind(folder, 0) == 0) result += line + "\n";
  return result;
}

// The lines that explain them.
std::string explanations() {
  std::string result;
  std::ifstream file{exceptions_path};
  for (std::string line; std::getline(file, line);)
    if (!line.empty() && line.front() == '#') result += line + "\n";
  return result;
}

bool has_integral(const Term& term) {
  return term.operation() == Operation::integral ||
         std::any_of(term.children().begin(), term.children().end(), has_integral);
}

std::string kind_of(const CheckedLink& link, const Term& before) {
  if (link.link.relation != Relation::equal) return "inequality";
  return has_integral(before) || has_integral(link.link.term) ? "integral" : "other equation";
}

class Walk {
 public:
  void over(const std::string& file, const Case& given) {
    file_ = file;
    VerificationOptions options;
    options.engines = Engines::kernel;
    const CaseResult result = verified(given, options);
    const CaseDerivation derivation = case_derivation(result, Detail::steps, Engines::both);
    where_ = "a definition of " + given.name;
    over(derivation.definitions, {});
    for (const ClaimDerivation& item : derivation.claims) {
      const ClaimResult& claim = result.claims.at(item.claim);
      const Decision& decision = claim.decision;
      where_ = given.name + "." + claim.claim.label + claim.claim.instance + ", " +
               to_text(decision.verdict);
      over(item.derivation, decision.conditions);
      const bool decided = decision.verdict == Verdict::proved ||
                           decision.verdict == Verdict::proved_if ||
                           decision.verdict == Verdict::refuted;
      if (decided && item.derivation.passages().empty())
        conditions_[file_ + ": no passage for " + where_];
    }
  }

  // One line for each kind of exception in a file.
  std::string exceptions() const {
    std::string result;
    for (const auto& [what, count] : kernel_only_)
      result += what + ": " + std::to_string(count) + "\n";
    for (const auto& [where, conditions] : conditions_) {
      result += where;
      for (const std::string& condition : conditions)
        result += (condition == *conditions.begin() ? " " : ", ") + condition;
      result += "\n";
    }
    return result;
  }

  std::size_t links() const { return links_; }

 private:
  void over(const CheckedDerivation& derivation, const std::vector<std::string>& conditions) {
    for (const CheckedPassage& passage : derivation.passages()) {
      if (passage.open) continue;
      for (const CheckedChain& chain : passage.chains) {
        const Term* before = &chain.start;
        for (const CheckedLink& link : chain.links) {
          over(link, *before, conditions);
          before = &link.link.term;
        }
      }
    }
  }

  void over(const CheckedLink& link, const Term& before,
            const std::vector<std::string>& conditions) {
    ++links_;
    const Decision& decision = link.decision;
    const bool holds =
        decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
    INFO(where_ << ": " << to_text(before, 200) << " | " << to_text(link.link.term, 200));
    CHECK(holds);
    if (decision.evidence != Evidence::both_engines) {
      CHECK(decision.evidence == Evidence::kernel);
      ++kernel_only_[file_ + ": by the kernel alone, " + kind_of(link, before)];
    }
    for (const std::string& condition : decision.conditions)
      if (std::find(conditions.begin(), conditions.end(), condition) == conditions.end())
        conditions_[file_ + ": " + where_ + ", needs"].insert(condition);
  }

  std::string file_;
  std::string where_;
  std::size_t links_ = 0;
  std::map<std::string, int> kernel_only_;
  std::map<std::string, std::set<std::string>> conditions_;
};

// PATCHPROOF_WALK=cases/coons/ looks at that folder only: CTest runs them side by side.
std::string chosen_folder() {
  const char* folder = std::getenv("PATCHPROOF_WALK");
  return folder == nullptr ? "" : folder;
}

// The file of exceptions is written anew by a run over all folders.
bool writes_anew() {
  return chosen_folder().empty() && std::getenv("PATCHPROOF_WRITE_GOLDEN") != nullptr;
}

// "cases/coons/form.proof"
std::string file_of(const std::string& path) { return path.substr(path.rfind("cases/")); }

// Under sanitizers of each folder the first file.
std::vector<SourceText> chosen_files() {
  std::vector<SourceText> files = case_files(chosen_folder());
  if (sanitized && files.size() > 1) files.resize(1);
  return files;
}

}  // namespace

TEST_CASE("every step of every derivation of cases/ is decided") {
  Walk walk;
  for (const SourceText& source : chosen_files()) {
    const ReadFile file =
        read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
    REQUIRE(file.diagnostics.empty());
    for (const Case& given : file.cases) {
      INFO(given.name);
      CHECK_NOTHROW(walk.over(file_of(source.name), given));
    }
  }
  WARN(walk.links() << " links");
  CHECK(walk.links() > 0);
  if (sanitized) return;
  if (writes_anew()) {
    const std::string text = explanations() + walk.exceptions();
    std::ofstream{exceptions_path} << text;
  }
  CHECK(walk.exceptions() == expected_exceptions(chosen_folder()));
}

}  // namespace patchproof::test
