#pragma once

#include <map>
#include <string>
#include <vector>

#include <patchproof/term/notation.hpp>
#include <patchproof/term/term.hpp>

namespace patchproof {

/// What terms are called in a case, and how it writes its names.
struct LatexNames {
  Notation notation;
  /// Functions, matrices and values that were given a name -> that name.
  std::map<const TermNode*, std::string> named;
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
