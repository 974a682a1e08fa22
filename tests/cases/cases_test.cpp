#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include <patchproof/claims/verification.hpp>
#include <patchproof/language/reader.hpp>
#include <patchproof/term/replacement.hpp>
#include <tests/cases/case_files.hpp>

namespace patchproof::test {

namespace {

// Shared parts of a term are looked at once.
bool has_integral(const Term& term, std::set<const TermNode*>& seen) {
  if (!seen.insert(term.address()).second) return false;
  if (term.operation() == Operation::integral) return true;
  return std::any_of(term.children().begin(), term.children().end(),
                     [&](const Term& child) { return has_integral(child, seen); });
}

bool has_integral(const Term& term) {
  std::set<const TermNode*> seen;
  return has_integral(term, seen);
}

// The second engine judges equations only, and integrates polynomials only.
bool is_for_both_engines(const Statement& statement) {
  if (statement.relation != Relation::equal) return false;
  if (!has_integral(statement.left) && !has_integral(statement.right)) return true;
  std::map<unsigned, SymbolPointer> symbols = free_symbols(statement.left);
  symbols.merge(free_symbols(statement.right));
  return std::none_of(symbols.begin(), symbols.end(), [](const auto& entry) {
    return entry.second->role == Symbol::Role::function;
  });
}

}  // namespace

TEST_CASE("every claim of cases/ is decided as expected, and every equation by both engines") {
  std::size_t claims = 0;
  for (const SourceText& source : sampled_case_files()) {
    const ReadFile file =
        read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
    INFO(source.name);
    REQUIRE(file.diagnostics.empty());
    for (const Case& given : file.cases) {
      for (const ClaimResult& result : verified(given, {}).claims) {
        ++claims;
        INFO(given.name << "." << result.claim.label << result.claim.instance << ": "
                        << to_text(result.decision.verdict) << " " << result.decision.reason);
        CHECK(result.outcome == Outcome::as_expected);
        bool for_both = true;
        if (const auto* identity = std::get_if<IdentityClaim>(&result.claim.kind))
          for (const Statement& s : identity->goal.statements)
            for_both = for_both && is_for_both_engines(s);
        if (for_both) CHECK(result.decision.evidence == Evidence::both_engines);
      }
    }
  }
  CHECK(claims > (sanitized ? 20u : 200u));
}

}  // namespace patchproof::test
