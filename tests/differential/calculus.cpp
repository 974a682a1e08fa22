#include <algorithm>

#include "rewriting.hpp"

namespace patchproof::differential {
namespace {

bool mentions(const Node& node, const std::string& variable) {
  if (node->kind == Kind::name && node->text == variable) return true;
  return std::any_of(node->operands.begin(), node->operands.end(),
                     [&](const Node& operand) { return mentions(operand, variable); });
}

Node derivative_of_apply(const Node& node, const std::string& variable, const Draft& draft) {
  const Node& function = node->operands[0];
  for (const DeclaredFunction& declared : draft.functions) {
    if (function->kind != Kind::name || function->text != declared.name) continue;
    std::vector<Node> terms;
    for (std::size_t i = 1; i < node->operands.size(); ++i) {
      const Node inner = derivative_written_out(node->operands[i], variable, draft);
      if (!inner) return nullptr;
      if (inner->text == "0") continue;
      const std::vector<Node> arguments(node->operands.begin() + 1, node->operands.end());
      const Node outer =
          apply(function, arguments, node->type, node->derivative + declared.formals[i - 1]);
      terms.push_back(inner->text == "1" ? outer : product({inner, outer}));
    }
    return sum(terms);
  }
  return nullptr;
}

Node derivative_of_product(const Node& node, const std::string& variable, const Draft& draft) {
  std::vector<Node> terms;
  for (std::size_t i = 0; i < node->operands.size(); ++i) {
    const Node inner = derivative_written_out(node->operands[i], variable, draft);
    if (!inner) return nullptr;
    if (inner->text == "0") continue;
    std::vector<Node> factors = node->operands;
    factors[i] = inner;
    terms.push_back(product(factors));
  }
  return sum(terms);
}

}  // namespace

Node derivative_written_out(const Node& node, const std::string& variable, const Draft& draft) {
  if (!mentions(node, variable)) return number(0);
  switch (node->kind) {
    case Kind::name:
      return node->text == variable ? number(1) : nullptr;
    case Kind::sum: {
      std::vector<Node> terms;
      for (const Node& operand : node->operands) {
        const Node inner = derivative_written_out(operand, variable, draft);
        if (!inner) return nullptr;
        if (inner->text != "0") terms.push_back(inner);
      }
      return sum(terms);
    }
    case Kind::negative: {
      const Node inner = derivative_written_out(node->operands[0], variable, draft);
      return inner ? negative(inner) : nullptr;
    }
    case Kind::product:
      return derivative_of_product(node, variable, draft);
    case Kind::power: {
      const Node inner = derivative_written_out(node->operands[0], variable, draft);
      const auto exponent = static_cast<unsigned>(std::stoul(node->text));
      if (!inner || exponent < 2) return nullptr;
      return product(
          {number(static_cast<long>(exponent)), power(node->operands[0], exponent - 1), inner});
    }
    case Kind::apply:
      return derivative_of_apply(node, variable, draft);
    default:
      return nullptr;
  }
}

}  // namespace patchproof::differential
