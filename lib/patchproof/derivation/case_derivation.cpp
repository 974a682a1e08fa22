#include <patchproof/derivation/case_derivation.hpp>

#include <map>
#include <set>
#include <tuple>

#include <patchproof/derivation/claim_derivation.hpp>
#include <patchproof/derivation/shapes.hpp>
#include <patchproof/derivation/tidied.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

// How the name, and each entry of an array, is printed without more ado.
std::vector<std::string> printed_names(const Declaration& declaration, const Notation& notation) {
  const Term& term = declaration.term;
  if (!declaration.given || !is_array(term))
    return {latex_name(declaration.name, notation).text()};
  std::vector<std::string> result;
  for (const Term& entry : term.children())
    result.push_back(latex_name(entry.symbol()->name, notation).text());
  return result;
}

// Of two names that would be printed alike, such as C1 and C_1, the later one is printed as it is
// written in the case.
void tell_apart(const Case& given, Notation& notation) {
  std::map<std::string, std::string> owners;
  for (const Declaration& declaration : given.declarations) {
    bool taken = false;
    for (const std::string& printed : printed_names(declaration, notation)) {
      const auto [owner, fresh] = owners.try_emplace(printed, declaration.name);
      taken = taken || (!fresh && owner->second != declaration.name);
    }
    if (taken) notation.names[declaration.name] = "\\mathtt{" + latex_escaped(declaration.name) + "}";
  }
}

LatexNames names_of(const Case& given) {
  LatexNames names;
  names.notation = given.notation;
  tell_apart(given, names.notation);
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
    if (!fresh || term.children().empty() || (is_array(term) && declaration.given)) continue;
    if (!term.type().is_function()) {
      // Another name for something that has one is never written.
      const std::string* name = computation.name_of(term);
      if (name == nullptr || *name != declaration.name) continue;
      if (computation.is_brief(term))
        // Nets written by a formula are full of 0 and 1.
        passage.chains.push_back({term, {{Relation::equal, tidied(without_name(term)), {}}}});
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

// Instances of a family that are decided in the same way: place and label, verdict, outcome, and
// whether there are conditions.
using Likeness = std::tuple<std::size_t, std::string, Verdict, Outcome, Evidence, bool>;

Likeness likeness(const ClaimResult& claim) {
  return {claim.claim.span.begin,    claim.claim.label,       claim.decision.verdict,
          claim.outcome,             claim.decision.evidence, claim.decision.conditions.empty()};
}

}  // namespace

CaseDerivation case_derivation(const CaseResult& result, Detail detail, Engines engines) {
  CaseDerivation derivation{names_of(result.verified), {}, {}};
  Computation computation{derivation.names, detail, result.verified.limits};
  derivation.definitions = CheckedDerivation{definitions_of(result.verified, computation),
                                              result.verified.limits, engines};
  std::map<Likeness, std::size_t> shown;
  for (std::size_t k = 0; k < result.claims.size(); ++k) {
    const ClaimResult& claim = result.claims[k];
    const auto [place, first] = shown.try_emplace(likeness(claim), derivation.claims.size());
    if (!first && detail != Detail::all) {
      ++derivation.claims[place->second].further_instances;
      continue;
    }
    ClaimDerivation item{k, 0, {}};
    if (detail != Detail::result)
      item.derivation = CheckedDerivation{
          claim_derivation(claim, claim.known, computation),
          result.verified.limits, engines};
    derivation.claims.push_back(std::move(item));
  }
  return derivation;
}

}  // namespace patchproof
