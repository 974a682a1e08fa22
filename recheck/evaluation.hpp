#pragma once

#include <recheck/field.hpp>

namespace recheck {

/// What a term is worth: its coordinates, entries row by row; of a function, its value at its
/// formal parameters.
struct Value {
  std::vector<Quotient> components;
  /// What was divided by: none of them may vanish.
  Polynomials divisors;
  /// Of functions: the atoms of the formal parameters.
  std::vector<Atom> formals;
};

/// Values given to symbols.
using Assignment = std::map<SymbolIndex, Value>;

/// Works out the nodes of a certificate as rational functions in atoms, one after the other.
///
/// The value of a node depends on nothing around it, so it is worked out once. Names of definitions
/// mean nothing: only their expansions count.
class Evaluator {
 public:
  Evaluator(const std::vector<Node>& nodes, Field& field, Assignment assignment = {})
      : nodes_{nodes}, field_{field}, assignment_{std::move(assignment)}, values_(nodes.size()) {}

  /// @throws LimitReached, Unsupported, Rejection
  const Value& value(NodeIndex node);

  Field& field() const { return field_; }

 private:
  Value compute(const Node& node) const;
  const Value& child(const Node& node, std::size_t k) const { return *values_[node.children[k]]; }
  Value of_symbol(SymbolIndex symbol) const;
  Value of_apply(const Node& node) const;
  Value of_derivative(const Node& node) const;
  Value of_integral(const Node& node) const;
  Value of_quotient(const Node& node) const;
  Value of_power(const Node& node) const;
  Value of_product(const Node& node) const;
  Value of_polynomial(const Node& node, const std::vector<Rational>& coefficients) const;
  std::vector<Quotient> of_vectors(const Node& node) const;

  const std::vector<Node>& nodes_;
  Field& field_;
  Assignment assignment_;
  std::vector<std::optional<Value>> values_;
};

}  // namespace recheck
