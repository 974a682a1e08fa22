#include "places.hpp"

namespace patchproof::differential {
namespace {

bool is_open(const Node& node, std::size_t operand) {
  switch (node->kind) {
    case Kind::element:
    case Kind::running_sum:
      return false;
    case Kind::apply:
      return operand > 0;
    case Kind::quotient:
      return operand == 0;
    case Kind::integral:
      return operand == 0;
    case Kind::call:
      if (node->text == "diff") return operand == 0;
      return node->text == "dot" || node->text == "cross" || node->text == "transpose" ||
             node->text == "det";
    default:
      return true;
  }
}

Node changed(const Node& node, std::size_t& left, const Node& instead) {
  if (left == 0) {
    --left;
    return instead;
  }
  --left;
  std::vector<Node> operands = node->operands;
  bool is_new = false;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (!is_open(node, i) || left == static_cast<std::size_t>(-1)) continue;
    const Node operand = changed(operands[i], left, instead);
    is_new = is_new || operand != operands[i];
    operands[i] = operand;
  }
  return is_new ? with_operands(node, std::move(operands)) : node;
}

}  // namespace

std::vector<Node> places(const Node& node) {
  std::vector<Node> result{node};
  for (std::size_t i = 0; i < node->operands.size(); ++i) {
    if (!is_open(node, i)) continue;
    const std::vector<Node> inner = places(node->operands[i]);
    result.insert(result.end(), inner.begin(), inner.end());
  }
  return result;
}

Node with_place(const Node& node, std::size_t place, const Node& instead) {
  return changed(node, place, instead);
}

}  // namespace patchproof::differential
