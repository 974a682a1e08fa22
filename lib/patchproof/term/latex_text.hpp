#pragma once

#include <map>
#include <string>
#include <vector>

#include <patchproof/term/notation.hpp>
#include <patchproof/term/term.hpp>

namespace patchproof {

/// A term with the name it was given.
struct NamedTerm {
  Term term;
  std::string name;
};

/// What terms are called in a case, and how it writes its names.
struct LatexNames {
  Notation notation;

  /// From now on the function, matrix or value is written by this name. Symbols have their own.
  void add(const Term& term, const std::string& name);
  /// The name that was given to the term, which may since have been mentioned at another place;
  /// none if it has none.
  const std::string* name_of(const Term& term) const;

  /// In the order they were given.
  const std::vector<NamedTerm>& all() const { return all_; }

 private:
  /// By the first child, which all mentions of one term share.
  std::multimap<const TermNode*, std::size_t> places_;
  std::vector<NamedTerm> all_;
};

/// The term in LaTeX mathematics, in the order and shape it was written: sums and products keep
/// their order, `(1-u)^3` stays `(1-u)^{3}`, numbers are `\tfrac13`, matrices `pmatrix`.
///
/// Needs amsmath. Depends on nothing but its arguments.
std::string to_latex(const Term& term, const LatexNames& names);

/// The summands of the term one by one, each with its sign ("+ 2u", "- V_{00}"; the first without a
/// plus), for breaking long lines. One entry when it is no sum.
std::vector<std::string> latex_summands(const Term& term, const LatexNames& names);

}  // namespace patchproof
