#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <patchproof/certificate/scalar.hpp>

namespace patchproof {

/// Something a Rocq statement quantifies over: V : nat -> nat -> R for all entries of an array,
/// C1 : R -> R, a : R.
struct RocqVariable {
  std::string name;
  /// How many natural numbers come first: indices of an array, and the number of a coordinate.
  std::size_t indices = 0;
  /// How many real arguments a function takes; 0 for a number.
  std::size_t arity = 0;
  Symbol::Role role = Symbol::Role::scalar;

  /// "nat -> nat -> R"
  std::string type() const;
};

/// Names for the symbols of a case, without two meanings for one name and without words of Rocq or of
/// the support library.
class RocqNames {
 public:
  /// Notes a symbol; those of one array share a variable.
  void add(const SymbolPointer& symbol);
  /// A name that is not in use, as near to the one wanted as can be; taken from now on.
  std::string fresh(const std::string& wanted);

  /// "u", "V 1%nat 2%nat"
  std::string text(const Coordinate& coordinate) const;
  const RocqVariable& variable(const SymbolPointer& symbol) const;
  /// Those of a variable, with the numbers they are applied to.
  const std::vector<unsigned>& indices(const SymbolPointer& symbol) const;

 private:
  struct Place {
    std::size_t variable = 0;
    std::vector<unsigned> indices;
  };
  const Place& place_of(const SymbolPointer& symbol) const;

  std::vector<RocqVariable> variables_;
  std::map<unsigned, Place> places_;
  std::map<std::string, std::size_t> arrays_;
  std::set<std::vector<unsigned>> used_;
  std::set<std::string> taken_;
};

/// A name as Rocq may have it: letters, digits, _ and '.
std::string rocq_identifier(const std::string& name);

}  // namespace patchproof
