#pragma once

#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include <patchproof/certificate/python_names.hpp>
#include <patchproof/certificate/scalar.hpp>
#include <patchproof/certificate/scalar_symbols.hpp>

namespace patchproof {

/// Writes scalars as expressions of Python over SymPy: (1 - u)*C1(0), derivative(r, 1, 0)(0, v).
///
/// What the case has a name for becomes a definition, made when it is first needed.
class PythonText {
 public:
  explicit PythonText(PythonNames& names) : names_{names} {}

  std::string of(const ScalarPointer& scalar) { return expression(scalar, 100); }
  /// To be put beside an operator: in brackets unless it is a name or a call.
  std::string factor(const ScalarPointer& scalar) { return expression(scalar, 0); }
  /// A function as something that can be called: "C1", "(lambda u: 1 - u)", "derivative(r, 1, 0)".
  std::string of(const ScalarFunctionPointer& function) { return function_text(function); }

  /// The definitions made so far, each after those it needs.
  const std::vector<std::string>& definitions() const { return definitions_; }

 private:
  using Symbols = ScalarSymbols::Symbols;

  std::string expression(const ScalarPointer& scalar, int level);
  std::string sum(const Scalar& scalar, int level);
  std::string product(const Scalar& scalar, int level);
  std::string quotient(const Scalar& scalar);
  std::string application(const Scalar& scalar, int level);
  std::string plain_name(const ScalarPointer& scalar);
  std::string function_text(const ScalarFunctionPointer& function);
  std::string derivative_text(const ScalarFunctionPointer& function);
  std::string lambda(const std::vector<SymbolPointer>& formals, const ScalarPointer& body);
  std::string named(const std::string& name, std::size_t component, const void* key,
                    const ScalarPointer& value, const ScalarFunctionPointer& function);
  /// Whether its value surely is one of SymPy: whole numbers of Python do not divide exactly.
  bool is_symbolic(const Scalar& scalar) const;
  bool depends_on_bound(const Symbols& symbols) const;
  std::string variable(const Coordinate& coordinate);
  /// The formals get names that mean nothing else inside.
  std::vector<std::string> enter(const std::vector<SymbolPointer>& formals, const ScalarPointer& body);

  PythonNames& names_;
  ScalarSymbols symbols_;
  /// Bound variables in scope.
  std::map<unsigned, std::string> bound_;
  std::vector<std::string> definitions_;
  /// Name wanted and text of a definition -> the name it got.
  std::map<std::string, std::string> meanings_;
  /// What was defined -> its name.
  std::unordered_map<const void*, std::string> defined_;
  /// Keeps alive what `defined_` has addresses of.
  std::vector<ScalarPointer> seen_;
  std::vector<ScalarFunctionPointer> seen_functions_;
};

}  // namespace patchproof
