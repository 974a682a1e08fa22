#include "expression.hpp"

#include <algorithm>

namespace patchproof::differential {
namespace {

Node made(Kind kind, Type type, std::string text, std::vector<Node> operands,
          std::string derivative = "") {
  return std::make_shared<const Expression>(
      Expression{kind, type, std::move(text), std::move(operands), std::move(derivative)});
}

/// The type of a sum or product: that of the operand that is most.
Type largest_type(const std::vector<Node>& operands) {
  Type result = Type::scalar;
  for (const Node& operand : operands) result = std::max(result, operand->type);
  return result;
}

}  // namespace

Node number(const std::string& text) { return made(Kind::number, Type::scalar, text, {}); }

Node number(long value) {
  return value < 0 ? negative(number(std::to_string(-value))) : number(std::to_string(value));
}

Node scalar_name(const std::string& text) { return made(Kind::name, Type::scalar, text, {}); }
Node point_name(const std::string& text) { return made(Kind::name, Type::point, text, {}); }
Node function_name(const std::string& text) { return made(Kind::name, Type::function, text, {}); }
Node matrix_name(const std::string& text) { return made(Kind::name, Type::matrix, text, {}); }

Node element(const std::string& array, std::vector<Node> indices, Type type) {
  return made(Kind::element, type, array, std::move(indices));
}

Node sum(std::vector<Node> operands) {
  if (operands.empty()) return number(0);
  if (operands.size() == 1) return operands.front();
  const Type type = largest_type(operands);
  return made(Kind::sum, type, "", std::move(operands));
}

Node difference(const Node& a, const Node& b) { return sum({a, negative(b)}); }
Node negative(const Node& a) { return made(Kind::negative, a->type, "", {a}); }

Node product(std::vector<Node> operands) {
  if (operands.size() == 1) return operands.front();
  const Type type = largest_type(operands);
  return made(Kind::product, type, "", std::move(operands));
}

Node quotient(const Node& a, const Node& b) { return made(Kind::quotient, a->type, "", {a, b}); }

Node power(const Node& base, unsigned exponent) {
  return made(Kind::power, base->type, std::to_string(exponent), {base});
}

Node apply(const Node& function, std::vector<Node> arguments, Type type,
           const std::string& derivative) {
  arguments.insert(arguments.begin(), function);
  return made(Kind::apply, type, "", std::move(arguments), derivative);
}

Node call(const std::string& name, std::vector<Node> operands, Type type) {
  return made(Kind::call, type, name, std::move(operands));
}

Node running_sum(const Node& body, const std::string& index, const Node& low, const Node& high) {
  return made(Kind::running_sum, body->type, index, {body, low, high});
}

Node integral(const Node& body, const std::string& variable, const Node& low, const Node& high) {
  return made(Kind::integral, body->type, variable, {body, low, high});
}

Node matrix(std::size_t columns, std::vector<Node> entries) {
  return made(Kind::matrix, Type::matrix, std::to_string(columns), std::move(entries));
}

Node with_operands(const Node& of, std::vector<Node> operands) {
  return made(of->kind, of->type, of->text, std::move(operands), of->derivative);
}

Node replaced(const Node& in, const std::function<Node(const std::string& name)>& value) {
  if (in->kind == Kind::name) {
    const Node found = value(in->text);
    return found ? found : in;
  }
  if (in->operands.empty()) return in;
  std::vector<Node> operands;
  for (const Node& operand : in->operands) operands.push_back(replaced(operand, value));
  return with_operands(in, std::move(operands));
}

}  // namespace patchproof::differential
