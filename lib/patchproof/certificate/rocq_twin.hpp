#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <patchproof/certificate/scalar.hpp>

namespace patchproof {

/// Writes scalars as terms of the support library, whose variables are numbers: those of the binders
/// around them, the innermost first, then the variables of the statement.
class RocqTwin {
 public:
  std::string of(const ScalarPointer& scalar);
  std::string of(const ScalarFunctionPointer& function);
  /// A function of these symbols, as the library has it: Lam 1 (…).
  std::string lambda(const std::vector<SymbolPointer>& formals, const ScalarPointer& body);

  /// The variables and unknown functions met so far, in the order of their numbers.
  const std::vector<Coordinate>& variables() const { return variables_; }
  const std::vector<Coordinate>& functions() const { return functions_; }

 private:
  using Key = std::pair<unsigned, std::size_t>;
  std::string pair(const char* name, const Scalar& scalar);
  std::string variable(const Coordinate& coordinate);

  std::vector<Key> bound_;  ///< the innermost last
  std::vector<Coordinate> variables_;
  std::vector<Coordinate> functions_;
  std::map<Key, std::size_t> variable_numbers_;
  std::map<Key, std::size_t> function_numbers_;
};

}  // namespace patchproof
