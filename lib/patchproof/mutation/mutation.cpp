#include <patchproof/mutation/mutation.hpp>

#include <algorithm>
#include <deque>

#include <patchproof/language/lexer.hpp>
#include <patchproof/mutation/better_data.hpp>
#include <patchproof/mutation/case_mutator.hpp>

namespace patchproof {

namespace {

const Case* read_case(const syntax::Case& written, const std::vector<Case>& cases) {
  for (const Case& given : cases)
    if (given.span.begin == written.name.span.begin || given.name == written.name.text)
      return &given;
  return nullptr;
}

/// The definitions of the file that its cases use, perhaps by way of other definitions.
std::set<std::string> used_definitions(const syntax::File& file) {
  std::set<std::string> used;
  const auto add = [&](const Span& part, const std::vector<Token>& tokens) {
    for (const Token& token : tokens)
      if (token.kind == Token::Kind::name && token.begin >= part.begin && token.end <= part.end)
        used.insert(file.source->text.substr(token.begin, token.end - token.begin));
  };
  const std::vector<Token> tokens = tokens_of(file.source).tokens;
  for (const syntax::Case& written : file.cases) add(written.span, tokens);
  // A definition uses only those above it.
  for (auto d = file.definitions.rbegin(); d != file.definitions.rend(); ++d)
    if (used.contains(d->name.text)) add(d->span, tokens);
  return used;
}

/// What all cases together make of an error in a definition.
Fate fate_in_all(const std::deque<CaseMutator>& cases, const Site& site, const SiteError& error) {
  Fate result = Fate::survives;
  for (const CaseMutator& of : cases) {
    const Fate fate = of.fate(site, error);
    if (fate == Fate::noticed || fate == Fate::meaningless || fate == Fate::internal) return fate;
    if (fate == Fate::undecided) result = fate;
  }
  return result;
}

void explain_in_all(const std::deque<CaseMutator>& cases, Mutant& mutant) {
  mutant.why = Mutant::Why::independent;
  for (const CaseMutator& of : cases) {
    Mutant here = mutant;
    of.explain(Site::Kind::definition, here);
    if (here.why != Mutant::Why::data) continue;
    mutant = here;
    return;
  }
}

CaseMutation definitions_of(const syntax::File& file, const std::deque<CaseMutator>& cases,
                            std::size_t most) {
  CaseMutation result;
  const std::set<std::string> used = used_definitions(file);
  for (const syntax::Definition& definition : file.definitions) {
    if (!used.contains(definition.name.text)) continue;
    const Site site = site_of(definition);
    result.sites.push_back(mutants_of(site, most, [&](const SiteError& error) {
      Mutant mutant{error, {}, fate_in_all(cases, site, error), {}, {}, {}};
      if (mutant.fate == Fate::survives) explain_in_all(cases, mutant);
      return mutant;
    }));
  }
  return result;
}

void add_hidden(const CaseMutation& in, std::vector<const Mutant*>& hidden) {
  for (const SiteMutants& site : in.sites)
    for (const Mutant& mutant : site.mutants)
      if (mutant.why == Mutant::Why::data) hidden.push_back(&mutant);
}

}  // namespace

std::vector<CaseMutation> mutations_of(const syntax::File& file, const std::vector<Case>& cases,
                                       const MutationOptions& options) {
  std::deque<CaseMutator> mutators;
  std::vector<CaseMutation> result(1);
  bool everything = true;
  for (const syntax::Case& written : file.cases) {
    const Case* given = read_case(written, cases);
    if (given == nullptr) continue;
    CaseMutator& of = mutators.emplace_back(file, written, *given, options);
    everything = everything && of.wants_everything();
    const bool any = std::any_of(given->claims.begin(), given->claims.end(),
                                 [&](const Claim& claim) { return of.wants(claim.label); });
    if (!any) {
      mutators.pop_back();
      continue;
    }
    CaseMutation& mutation = result.emplace_back();
    mutation.name = given->name;
    if (options.progress) options.progress(*given);
    of.look_at_claims(mutation);
    mutation.sites = of.sites();
  }
  if (everything) result.front() = definitions_of(file, mutators, options.most);
  for (std::size_t k = 0; k < mutators.size(); ++k) {
    std::vector<const Mutant*> hidden;
    add_hidden(result[k + 1], hidden);
    add_hidden(result.front(), hidden);
    if (hidden.empty()) continue;
    result[k + 1].hidden = hidden.size();
    for (const Data& data : mutators[k].data())
      if (hides(data, hidden))
        result[k + 1].shapes.insert(result[k + 1].shapes.end(), data.shape.begin(),
                                    data.shape.end());
    result[k + 1].better = better_data(mutators[k], hidden);
  }
  if (result.front().sites.empty()) result.erase(result.begin());
  return result;
}

}  // namespace patchproof
