#pragma once

#include <set>
#include <unordered_map>
#include <vector>

#include <patchproof/kernel/workspace.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof {

/// What a term is worth: its components (of one value, for functions), each a fraction in atoms,
/// and what must hold for the value to exist.
///
/// Entries of a matrix come row by row, components of a point in order; a point of any dimension
/// has one component that stands for all.
struct Value {
  std::vector<Fraction> components;
  Conditions conditions;
};

/// Turns terms into fractions in atoms: the kernel's reading of the textbook's vocabulary.
///
/// A function is evaluated once, at its formal parameters; applying it replaces them.
class Evaluator {
 public:
  explicit Evaluator(Workspace& workspace, const std::vector<KnownValue>& known = {});

  /// @throws NoValue, OutsideTheory, FinerAngles, OverBudget
  const Value& value(const Term& term);

  /// The variables of the formal parameters of a function term.
  std::vector<Variable> formals(const Term& function);

 private:
  Value compute(const Term& term);
  Value of_symbol(const Term& term);
  Value of_elementary(const Term& term);
  Value of_apply(const Term& term);
  Value of_derivative(const Term& term);
  Value of_vector_operation(const Term& term);
  Value of_matrix_product(const Term& term);
  Value of_basis(const Term& term);
  Value of_integral(const Term& term);
  Value pointwise(const Term& term);

  Workspace& workspace_;
  std::unordered_map<const TermNode*, Value> values_;
  /// Keeps the terms alive whose addresses are keys of `values_`.
  std::vector<Term> seen_;
  std::unordered_map<unsigned, Term> known_;
  /// Known symbols whose values are being worked out.
  std::set<unsigned> resolving_;
};

}  // namespace patchproof
