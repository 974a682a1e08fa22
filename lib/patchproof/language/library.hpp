#pragma once

#include <map>
#include <string>
#include <vector>

#include <patchproof/language/diagnostic.hpp>
#include <patchproof/language/net_file.hpp>
#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// What may be used: the definitions of the prelude and of files read so far, and files of nets.
class Library {
 public:
  /// The textbook constructions that come with the program.
  static const Library& prelude();

  /// Adds a definition; what is wrong with it is appended to `diagnostics`: a name that is taken, a
  /// name it uses that is not known (a definition may use only earlier ones, so never itself).
  void add(const syntax::Definition& definition, std::vector<Diagnostic>& diagnostics);

  const syntax::Definition* find(const std::string& name) const;
  /// Reads a file of a net, where that has not happened yet.
  void add_net(const std::string& path, const Loader& load);
  /// The file; nullptr when nobody asked for it to be read.
  const NetFile* net(const std::string& path) const;

  /// Names in the order they were added.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::map<std::string, syntax::Definition> definitions_;
  std::vector<std::string> names_;
  std::map<std::string, NetFile> nets_;
};

}  // namespace patchproof
