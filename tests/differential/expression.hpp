#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace patchproof::differential {

/// What an expression stands for. A matrix may hold points; points have any dimension or three.
enum class Type { scalar, point, matrix, function };

enum class Kind {
  number,       ///< text: "12", "3/7", "0.125"
  name,         ///< text: "u", "P", "P.x", a function "r"
  element,      ///< text[operands…]
  sum,          ///< operands; of several
  negative,     ///< -operand
  product,      ///< operands; of several
  quotient,     ///< operand / operand
  power,        ///< operand ^ text
  apply,        ///< a function, operand 0, at arguments; with derivatives
  call,         ///< text(operands…): a built-in or a construction of the prelude
  running_sum,  ///< sum(operand 0, text in operand 1..operand 2)
  integral,     ///< integral(operand 0, text in [operand 1, operand 2])
  matrix        ///< operands row by row; text is the number of columns
};

struct Expression;
using Node = std::shared_ptr<const Expression>;

/// An expression of the case language, only as far as random claims need it.
struct Expression {
  Kind kind;
  Type type;
  std::string text;
  std::vector<Node> operands;
  /// apply: the variables of the partial derivative, "uv"; of curves as often as it is taken.
  std::string derivative = {};
};

Node number(const std::string& text);
Node number(long value);
Node scalar_name(const std::string& text);
Node point_name(const std::string& text);
Node function_name(const std::string& text);
Node matrix_name(const std::string& text);
Node element(const std::string& array, std::vector<Node> indices, Type type);
/// Of one operand, that operand; of none, 0.
Node sum(std::vector<Node> operands);
Node difference(const Node& a, const Node& b);
Node negative(const Node& a);
Node product(std::vector<Node> operands);
Node quotient(const Node& a, const Node& b);
Node power(const Node& base, unsigned exponent);
Node apply(const Node& function, std::vector<Node> arguments, Type type,
           const std::string& derivative = "");
Node call(const std::string& name, std::vector<Node> operands, Type type);
Node running_sum(const Node& body, const std::string& index, const Node& low, const Node& high);
Node integral(const Node& body, const std::string& variable, const Node& low, const Node& high);
Node matrix(std::size_t columns, std::vector<Node> entries);

/// The same expression with other operands.
Node with_operands(const Node& of, std::vector<Node> operands);

/// With expressions in place of names.
Node replaced(const Node& in, const std::function<Node(const std::string& name)>& value);

/// As the case language writes it.
std::string case_text(const Node& node);
/// As an expression of Python, for tests/differential/opinion.py.
std::string python_text(const Node& node);

}  // namespace patchproof::differential
