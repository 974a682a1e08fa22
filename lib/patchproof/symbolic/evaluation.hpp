#pragma once

#include <map>
#include <unordered_map>
#include <vector>

#include <patchproof/symbolic/components.hpp>
#include <patchproof/symbolic/ring.hpp>
#include <patchproof/term/term.hpp>

namespace patchproof::symbolic {

/// What a term stands for. A function is its value at its formal parameters, which are atoms.
struct Value {
  Components components;
  std::vector<unsigned> formals;
};

/// Values of symbols by ordinal.
using SymbolValues = std::map<unsigned, Components>;

/// The values of terms as polynomials in atoms. Symbols that have a value are replaced by it.
///
/// Each shared part of a term is evaluated once; terms must outlive the evaluation.
class Evaluation {
 public:
  explicit Evaluation(Ring& ring, SymbolValues known = {});

  /// @throws OverBudget
  /// @throws std::domain_error when the term has no value, or not one this engine knows.
  const Value& operator()(const Term& term);

 private:
  Value evaluated(const Term& term);
  Value of_symbol(const Term& term);
  Value of_lambda(const Term& term);
  Value of_application(const Term& term);
  Value of_derivative(const Term& term);
  Value of_operation(const Term& term);
  Value of_integral(const Term& term);
  Components at(const Value& function, const Components& arguments);
  Components combined(const Term& term, const std::vector<Components>& children);

  Ring& ring_;
  SymbolValues known_;
  std::unordered_map<const TermNode*, Value> values_;
};

/// One atom for each component of a symbol that is no function.
Components letters(Ring& ring, const SymbolPointer& symbol);

}  // namespace patchproof::symbolic
