#pragma once

#include <map>
#include <unordered_map>
#include <vector>

#include <patchproof/certificate/scalar.hpp>

namespace patchproof {

/// All symbols that occur in scalars and functions and are not bound inside, by ordinal; worked out
/// once for each node.
class ScalarSymbols {
 public:
  using Symbols = std::map<unsigned, SymbolPointer>;

  const Symbols& of(const ScalarPointer& scalar);
  const Symbols& of(const ScalarFunctionPointer& function);

 private:
  std::unordered_map<const Scalar*, Symbols> free_;
  std::unordered_map<const ScalarFunction*, Symbols> free_in_functions_;
  /// Keeps alive what the maps have addresses of.
  std::vector<ScalarPointer> seen_;
  std::vector<ScalarFunctionPointer> seen_functions_;
};

}  // namespace patchproof
