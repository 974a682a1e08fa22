#include <catch2/catch.hpp>

#include <patchproof/claims/verification.hpp>
#include <tests/cases/mutation.hpp>

namespace patchproof::test {

TEST_CASE("every claim of cases/ is decided as expected, and every equation by both engines") {
  std::size_t claims = 0;
  for (const SourceText& source : case_files()) {
    const ReadFile file =
        read_cases(std::make_shared<const SourceText>(source), Limits{},
                   [](const std::string&) { return std::optional<std::string>{}; });
    INFO(source.name);
    REQUIRE(file.diagnostics.empty());
    for (const Case& given : file.cases) {
      for (const ClaimResult& result : verified(given, {}).claims) {
        ++claims;
        INFO(given.name << "." << result.claim.label << result.claim.instance << ": "
                        << to_text(result.decision.verdict) << " " << result.decision.reason);
        CHECK(result.outcome == Outcome::as_expected);
        // The second engine judges equations only.
        bool equations = true;
        if (const auto* identity = std::get_if<IdentityClaim>(&result.claim.kind))
          for (const Statement& s : identity->goal.statements)
            equations = equations && s.relation == Relation::equal;
        if (equations) CHECK(result.decision.evidence == Evidence::both_engines);
      }
    }
  }
  CHECK(claims > 200);
}

}  // namespace patchproof::test
