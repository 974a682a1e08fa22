#pragma once

#include <map>
#include <string>
#include <vector>

#include "expression.hpp"
#include "plain_polynomial.hpp"

namespace patchproof::differential {

/// A quotient of polynomials, nothing cancelled.
struct PlainFraction {
  PlainPolynomial above;
  PlainPolynomial below = plain_number(1);
};

/// A number, a matrix, or a point: of any dimension one generic coordinate, in R^3 a column.
struct Value {
  std::size_t rows = 1;
  std::size_t columns = 1;
  std::vector<PlainFraction> entries;

  const PlainFraction& at(std::size_t i, std::size_t j = 0) const {
    return entries.at(i * columns + j);
  }
};

Value value_of_number(const Rational& number);
Value value_of_variable(const std::string& name);
Value plus(const Value& a, const Value& b);
Value minus(const Value& a);
/// Of matrices; a single number multiplies everything.
Value times(const Value& a, const Value& b);
/// @throws std::domain_error when the divisor is 0.
Value divided(const Value& a, const Value& b);
Value differentiated(const Value& a, const std::string& variable);
Value substituted(const Value& a, const std::map<std::string, PlainFraction>& values);
bool same(const Value& a, const Value& b);

/// A function: its value at formal parameters "$1", "$2".
struct Function {
  std::size_t arity = 1;
  Value body;
};
Value applied(const Function& function, const std::vector<Value>& arguments);
/// The name of a formal parameter, the first is "$1".
std::string formal(std::size_t index);

/// A piecewise polynomial: piece k over [breaks[k], breaks[k+1]] in a local parameter from 0 to 1.
struct PlainSpline {
  std::vector<Rational> breaks;
  std::vector<Function> pieces;
};

/// What names stand for: nets, matrices, points of R^3, names that an assumption gives a value,
/// functions. Every other name is a variable.
struct Environment {
  std::map<std::string, Value> values;
  std::map<std::string, Function> functions;
  std::map<std::string, PlainSpline> splines = {};
};

/// What an expression is worth, by rules of its own: the third opinion besides the two engines.
/// @throws std::domain_error where it divides by zero, std::logic_error when it is not well typed.
Value meaning(const Node& node, const Environment& environment);

/// A function of the case: a name, a construction, or an expression in `formals`.
Function function_meaning(const Node& node, const Environment& environment,
                          const std::vector<std::string>& formals);

}  // namespace patchproof::differential
