#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <patchproof/term/latex_text.hpp>

namespace patchproof {

/// What one round of unfolding did.
struct Unfolded {
  Term term;
  /// The names that were written out, in order of appearance.
  std::vector<std::string> names;
  /// Whether derivatives were carried out on the way.
  bool differentiated = false;
  /// Whether all names only stood for other ones, as r for coons(C1, C2, D1, D2).
  bool only_renamed = true;
  /// Whether a function was put at a number, as in r(u, 0).
  bool numbers_put_in = false;
};

/// Writes names out, layer by layer: first those that are defined by others.
///
/// A name is a declared function or value of the case, or a definition that was used. Functions are
/// put at their arguments, and derivatives carried out by the rules of `differentiated`.
class Unfolding {
 public:
  explicit Unfolding(const LatexNames& names) : names_{names} {}

  /// 0 for a term without names, else one more than what the names in it stand for.
  int depth(const Term& term);

  /// The term with all names of its greatest depth written out; empty when a derivative of one of
  /// them follows no rule.
  std::optional<Unfolded> layer(const Term& term);

 private:
  int function_depth(const Term& function);

  const LatexNames& names_;
  std::unordered_map<const TermNode*, int> depths_;
  std::vector<Term> seen_;
};

}  // namespace patchproof
