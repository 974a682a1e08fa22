#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <patchproof/certificate/scalar.hpp>

namespace patchproof {

/// Names for the symbols of a case in a script of Python: `u`, `C1`, and `V[1, 2]` for an entry of an
/// array; the coordinate of a point comes last, `P[0]`. No name has two meanings or is a word of
/// Python or of the script.
class PythonNames {
 public:
  /// The name of a symbol, from now on always the same.
  std::string text(const Coordinate& coordinate);
  /// The name without indices.
  const std::string& stem(const SymbolPointer& symbol);
  /// A name that is not in use, as near to the one wanted as can be; taken from now on.
  std::string fresh(const std::string& wanted);
  /// Whether a global of the script has the name.
  bool is_taken(const std::string& name) const;
  /// Whether the name is that of a parameter of the case.
  bool is_parameter(const std::string& name) const { return parameters_.contains(name); }
  /// No definition gets this name from now on: it is bound in some function.
  void reserve(const std::string& formal) { formals_.insert(formal); }

  /// Lines that make all symbols that have got a name, in the order of declaration.
  std::string declarations() const;

 private:
  struct Variable {
    std::string name;
    /// How many real arguments a function takes; 0 for a number.
    std::size_t arity = 0;
    /// Of an array, one more than the largest index in each place.
    std::vector<unsigned> sizes;
    unsigned ordinal = 0;
  };
  struct Place {
    std::size_t variable = 0;
    std::vector<unsigned> indices;
    bool coordinates = false;
  };
  const Place& place_of(const SymbolPointer& symbol);
  std::string name_not_taken(const std::string& wanted, bool global) const;

  std::vector<Variable> variables_;
  std::map<unsigned, Place> places_;
  /// Array and shape -> variable; and its entries that are taken.
  std::map<std::string, std::size_t> arrays_;
  std::set<std::vector<unsigned>> used_;
  std::set<std::string> taken_;
  std::set<std::string> parameters_;
  std::set<std::string> formals_;
};

/// A name as Python may have it: letters, digits and _, not beginning with a digit.
std::string python_identifier(const std::string& name);

}  // namespace patchproof
