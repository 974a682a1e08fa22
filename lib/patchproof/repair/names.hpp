#pragma once

#include <string>
#include <vector>

#include <patchproof/language/library.hpp>
#include <patchproof/language/scope.hpp>

namespace patchproof {

/// Which names may stand in each other's place: those of things of one kind.
class Names {
 public:
  /// The scope and the library must outlive the names.
  Names(const Scope& scope, const Library& library) : scope_{scope}, library_{library} {}

  /// The other names of this kind, in the order of the alphabet. `running` are running indices
  /// known at the place, which are numbers.
  std::vector<std::string> others(const std::string& name,
                                  const std::vector<std::string>& running) const;

  /// The type of what the name stands for; null for splines, definitions and running indices.
  const Type* type(const std::string& name) const;
  /// Whether it runs over a range.
  bool is_parameter(const std::string& name) const;
  bool is_declared(const std::string& name) const { return scope_.find(name) != nullptr; }
  /// Whether a call of this definition or built-in function may be a matrix.
  bool may_make_matrix(const std::string& name) const;
  /// Whether it is defined in the case language.
  bool is_definition(const std::string& name) const { return library_.find(name) != nullptr; }

 private:
  std::string kind(const std::string& name) const;

  const Scope& scope_;
  const Library& library_;
};

}  // namespace patchproof
