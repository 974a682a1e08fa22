#pragma once

#include <map>
#include <string>
#include <vector>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// The definitions that may be used: those of the prelude, and those of files read so far.
class Library {
 public:
  /// The textbook constructions that come with the program.
  static const Library& prelude();

  /// Adds a definition; what is wrong with it is appended to `diagnostics`: a name that is taken, a
  /// name it uses that is not known (a definition may use only earlier ones, so never itself).
  void add(const syntax::Definition& definition, std::vector<Diagnostic>& diagnostics);

  const syntax::Definition* find(const std::string& name) const;
  /// Names in the order they were added.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::map<std::string, syntax::Definition> definitions_;
  std::vector<std::string> names_;
};

}  // namespace patchproof
