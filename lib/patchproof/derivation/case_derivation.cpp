#include <patchproof/derivation/case_derivation.hpp>

#include <map>
#include <set>

#include <patchproof/derivation/claim_derivation.hpp>
#include <patchproof/derivation/shapes.hpp>

namespace patchproof {

namespace {

LatexNames names_of(const Case& given) {
  LatexNames names;
  names.notation = given.notation;
  for (const Declaration& declaration : given.declarations) {
    const Operation operation = declaration.term.operation();
    const bool is_own_name = operation == Operation::symbol || operation == Operation::number;
    if (!is_own_name) names.add(declaration.term, declaration.name);
  }
  return names;
}

// What a function, matrix or value stands for, of the first instance of a family.
Derivation definitions_of(const Case& given, Computation& computation) {
  Passage passage{Passage::Kind::definition, {}, {}, {}};
  std::set<std::string> seen;
  for (const Declaration& declaration : given.declarations) {
    const Term& term = declaration.term;
    const bool fresh = seen.insert(declaration.name).second;
    if (!fresh || term.children().empty() || is_array(term)) continue;
    if (!term.type().is_function()) {
      if (computation.is_brief(term))
        passage.chains.push_back({term, {{Relation::equal, without_name(term), {}}}});
      continue;
    }
    if (term.operation() != Operation::lambda) continue;
    std::vector<Term> children{term};
    for (const SymbolPointer& formal : term.formals()) children.push_back(symbol_term(formal));
    const Term value = make_term(Operation::apply, *term.type().inner, std::move(children));
    passage.chains.push_back(computation.definition(value, term.child(0)));
  }
  return {{passage}};
}

// What the derivations used by a claim have found, of its own instance or of all.
std::vector<KnownValue> known_to(const Claim& claim, const CaseResult& result) {
  std::vector<KnownValue> known;
  std::set<unsigned> seen;
  for (const std::string& label : claim.uses)
    for (const ClaimResult& other : result.claims)
      if (other.claim.label == label && claim.instance.rfind(other.claim.instance.substr(
              0, other.claim.instance.empty() ? 0 : other.claim.instance.size() - 1), 0) == 0)
        for (const KnownValue& value : other.decision.solution)
          if (seen.insert(value.symbol->ordinal).second) known.push_back(value);
  return known;
}

}  // namespace

CaseDerivation case_derivation(const CaseResult& result, Detail detail, Engines engines) {
  CaseDerivation derivation{names_of(result.verified), {}, {}};
  Computation computation{derivation.names, detail, result.verified.limits};
  derivation.definitions = CheckedDerivation{definitions_of(result.verified, computation),
                                              result.verified.limits, engines};
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
      item.derivation = CheckedDerivation{
          claim_derivation(claim, known_to(claim.claim, result), computation),
          result.verified.limits, engines};
    derivation.claims.push_back(std::move(item));
  }
  return derivation;
}

}  // namespace patchproof
