#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include <patchproof/certificate/rocq_names.hpp>
#include <patchproof/certificate/scalar_symbols.hpp>

namespace patchproof {

/// A definition of something that the case has a name for.
struct RocqDefinition {
  std::string name;
  /// "Definition name … := …."
  std::string text;
};

/// Writes scalars as a reader of Rocq expects them: (1 - u) * C1 0, D_u (r V) 0 v.
///
/// What the case has a name for becomes a definition, made when it is first needed.
class RocqText {
 public:
  explicit RocqText(RocqNames& names) : names_{names} {}

  std::string of(const ScalarPointer& scalar) { return expression(scalar, 100); }
  /// A function as something that can be applied: "C1", "(fun u => 1 - u)", "D_u (r V)".
  std::string of(const ScalarFunctionPointer& function) { return function_text(function); }

  /// The definitions made so far, each after those it needs.
  const std::vector<RocqDefinition>& definitions() const { return definitions_; }

 private:
  using Symbols = std::map<unsigned, SymbolPointer>;

  std::string expression(const ScalarPointer& scalar, int level);
  std::string function_text(const ScalarFunctionPointer& function);
  std::string application(const Scalar& scalar);
  std::string binder(const std::vector<SymbolPointer>& formals, const ScalarPointer& body);
  std::string named(const std::string& name, std::size_t component, const void* key,
                    const Symbols& symbols, const ScalarPointer& value,
                    const ScalarFunctionPointer& function);
  const ScalarFunction& without_application(const ScalarFunction& function);
  bool depends_on_bound(const Symbols& symbols) const;
  std::string variable(const Coordinate& coordinate) const;
  /// The formals get names that mean nothing else inside.
  std::vector<std::string> enter(const std::vector<SymbolPointer>& formals, const Symbols& inside);

  RocqNames& names_;
  /// Bound variables in scope.
  std::map<unsigned, std::string> bound_;
  std::vector<RocqDefinition> definitions_;
  /// The text of a definition after its name -> the name it got.
  std::map<std::string, std::string> meanings_;
  /// What was defined -> "r V C1".
  std::unordered_map<const void*, std::string> defined_;
  ScalarSymbols symbols_;
};

}  // namespace patchproof
