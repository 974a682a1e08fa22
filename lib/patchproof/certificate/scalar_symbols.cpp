#include <patchproof/certificate/scalar_symbols.hpp>

#include <utility>

namespace patchproof {

const std::map<unsigned, SymbolPointer>& ScalarSymbols::of(const ScalarPointer& scalar) {
  const auto found = free_.find(scalar.get());
  if (found != free_.end()) return found->second;
  Symbols result;
  if (scalar->kind == Scalar::Kind::variable)
    result.emplace(scalar->coordinate.symbol->ordinal, scalar->coordinate.symbol);
  for (std::size_t k = 0; k < scalar->children.size(); ++k) {
    Symbols inner = of(scalar->children[k]);
    if (scalar->kind == Scalar::Kind::integral && k == 2) inner.erase(scalar->formal->ordinal);
    result.merge(inner);
  }
  if (scalar->function) {
    const Symbols& inner = of(scalar->function);
    result.insert(inner.begin(), inner.end());
  }
  seen_.push_back(scalar);
  return free_.emplace(scalar.get(), std::move(result)).first->second;
}

const std::map<unsigned, SymbolPointer>& ScalarSymbols::of(
    const ScalarFunctionPointer& function) {
  const auto found = free_in_functions_.find(function.get());
  if (found != free_in_functions_.end()) return found->second;
  Symbols result;
  switch (function->kind) {
    case ScalarFunction::Kind::unknown:
      result.emplace(function->coordinate.symbol->ordinal, function->coordinate.symbol);
      break;
    case ScalarFunction::Kind::lambda:
      result = of(function->body);
      for (const SymbolPointer& formal : function->formals) result.erase(formal->ordinal);
      break;
    default: result = of(function->inner); break;
  }
  seen_functions_.push_back(function);
  return free_in_functions_.emplace(function.get(), std::move(result)).first->second;
}

}  // namespace patchproof
