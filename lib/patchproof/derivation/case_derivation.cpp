#include <patchproof/derivation/case_derivation.hpp>

#include <set>

namespace patchproof {

namespace {

LatexNames names_of(const Case& given) {
  LatexNames names{given.notation, {}};
  for (const Declaration& declaration : given.declarations) {
    const Operation operation = declaration.term.operation();
    const bool is_own_name = operation == Operation::symbol || operation == Operation::number;
    if (!is_own_name) names.named.emplace(declaration.term.address(), declaration.name);
  }
  return names;
}

Derivation derivation_of(const ClaimResult&) { return {}; }

}  // namespace

CaseDerivation case_derivation(const CaseResult& result, Detail detail, Engines engines) {
  CaseDerivation derivation{names_of(result.verified), {}, {}};
  std::set<std::pair<std::size_t, std::string>> families;
  for (std::size_t k = 0; k < result.claims.size(); ++k) {
    const ClaimResult& claim = result.claims[k];
    const bool first = families.emplace(claim.claim.span.begin, claim.claim.label).second;
    if (!first && detail != Detail::all) {
      ++derivation.claims.back().further_instances;
      continue;
    }
    ClaimDerivation item{k, 0, {}};
    if (detail != Detail::result)
      item.derivation =
          CheckedDerivation{derivation_of(claim), result.verified.limits, engines};
    derivation.claims.push_back(std::move(item));
  }
  return derivation;
}

}  // namespace patchproof
