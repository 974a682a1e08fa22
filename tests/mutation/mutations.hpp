#pragma once

#include <memory>
#include <string>
#include <vector>

#include <patchproof/language/parser.hpp>
#include <patchproof/mutation/mutation.hpp>

namespace patchproof {

/// What becomes of the errors in a text; nothing for a text with mistakes.
inline std::vector<CaseMutation> mutations_in(const std::string& text,
                                              MutationOptions options = {}) {
  const auto source = std::make_shared<const SourceText>(SourceText{"a.proof", text});
  options.load = [](const std::string&) { return std::optional<std::string>{}; };
  const ReadFile file = read_cases(source, options.limits, options.load);
  if (!file.diagnostics.empty()) return {};
  return mutations_of(parse(source).file, file.cases, options);
}

/// The same for the statements of one case.
inline CaseMutation mutations_in_case(const std::string& statements,
                                      const MutationOptions& options = {}) {
  const std::vector<CaseMutation> all = mutations_in("case a\n" + statements + "end\n", options);
  return all.empty() ? CaseMutation{} : all.back();
}

/// The part with this name; an empty one where there is none.
inline SiteMutants part(const CaseMutation& of, const std::string& name) {
  for (const SiteMutants& site : of.sites)
    if (site.name == name) return site;
  return {};
}

/// The errors of a part that ended like this, in words.
inline std::vector<std::string> words(const SiteMutants& site, Fate fate,
                                      Mutant::Why why = Mutant::Why::none) {
  std::vector<std::string> result;
  for (const Mutant& mutant : site.mutants)
    if (mutant.fate == fate && mutant.why == why) result.push_back(mutant.change.error.words);
  return result;
}

}  // namespace patchproof
