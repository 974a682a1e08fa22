#include <catch2/catch.hpp>

#include <patchproof/claims/verification.hpp>
#include <patchproof/decide/trial.hpp>
#include <patchproof/language/reader.hpp>
#include <tests/cases/case_files.hpp>

namespace patchproof::test {

namespace {

bool has_equations_only(const Goal& goal) {
  for (const Statement& statement : goal.statements)
    if (statement.relation != Relation::equal) return false;
  return true;
}

}  // namespace

TEST_CASE("a quick look turns nothing down that is proved, and every equation that is refuted",
          "[law]") {
  std::size_t count = 0;
  for (const std::string part : {"lee", "ruled", "hermite/", "bilinear"}) {
    if (sanitized && part != "hermite/") continue;
    for (const SourceText& source : case_files(part)) {
      const ReadFile file =
          read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
      for (const Case& given : file.cases) {
        // One for all: what it remembers of one goal must not change its view of the next.
        Trial trial{given.limits};
        VerificationOptions options;
        options.engines = Engines::kernel;
        for (const ClaimResult& result : verified(given, options).claims) {
          const auto* identity = std::get_if<IdentityClaim>(&result.claim.kind);
          if (identity == nullptr || !result.claim.uses.empty()) continue;
          ++count;
          INFO(given.name << "." << result.claim.label << result.claim.instance);
          const Verdict verdict = result.decision.verdict;
          if (verdict == Verdict::proved || verdict == Verdict::proved_if)
            CHECK(trial.may_hold(identity->goal));
          if (verdict == Verdict::refuted && has_equations_only(identity->goal))
            CHECK_FALSE(trial.may_hold(identity->goal));
        }
      }
    }
  }
  CHECK((sanitized || count > 100));
}

}  // namespace patchproof::test
