#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// The names an author may have mixed up with each other: those written in one case or definition.
struct Vocabulary {
  /// All that are declared, with parameters and running indices, and what each of them is: the
  /// word it is declared with, or "parameter", "index", "formal".
  std::map<std::string, std::string> names;
  /// Parameters of functions, which may stand behind the '_' of a derivative.
  std::set<std::string> parameters;
  /// Names of nets and matrices, which can be transposed.
  std::set<std::string> nets;

  /// The names of the same kind that differ from this one in a single character: the next one in
  /// the alphabet on either side.
  std::vector<std::string> similar(const std::string& name) const;
};

/// The names of a case.
Vocabulary vocabulary_of(const syntax::Case& written);

/// The names of a definition: its formals, and what it gives names to itself.
Vocabulary vocabulary_of(const syntax::Definition& written);

}  // namespace patchproof
