#include "near_miss.hpp"

#include <stdexcept>

#include "places.hpp"

namespace patchproof::differential {
namespace {

Node other_number(const Node& node, Choices& choices) {
  switch (choices.below(4)) {
    case 0:
      return sum({node, number(1)});
    case 1:
      return difference(node, number("1/1000000000000000000000"));
    case 2:
      return sum({node, random_number(choices)});
    default:
      return negative(node);
  }
}

Node other_name(const Node& node, Choices& choices, const Draft& draft) {
  if (node->type == Type::scalar) return choices.one_of(draft.scalars);
  if (node->type == Type::point && !draft.points.empty()) return choices.one_of(draft.points);
  return node;
}

Node other_element(const Node& node, Choices& choices, const Draft& draft) {
  const Value& shape = draft.environment.values.at(node->text);
  const std::size_t i = choices.below(shape.rows);
  const std::size_t j = choices.below(shape.columns);
  return element_of(draft, node->text, i, j);
}

Node other_operands(const Node& node, Choices& choices) {
  std::vector<Node> operands = node->operands;
  const std::size_t i = choices.below(operands.size());
  if (node->kind == Kind::sum && choices.once_in(2)) {
    operands[i] =
        operands[i]->kind == Kind::negative ? operands[i]->operands[0] : negative(operands[i]);
    return with_operands(node, operands);
  }
  if (node->kind == Kind::product && operands[i]->type != Type::scalar) return negative(node);
  operands.erase(operands.begin() + static_cast<std::ptrdiff_t>(i));
  return node->kind == Kind::sum ? sum(operands) : product(operands);
}

Node other_application(const Node& node, Choices& choices) {
  std::vector<Node> arguments(node->operands.begin() + 1, node->operands.end());
  std::string derivative = node->derivative;
  const std::size_t i = choices.below(arguments.size());
  if (!derivative.empty() && choices.once_in(3)) {
    derivative.pop_back();
  } else if (arguments.size() == 2 && !derivative.empty() && choices.once_in(2)) {
    derivative.back() = derivative.back() == 'u' ? 'v' : 'u';
  } else if (arguments[i]->kind == Kind::number) {
    arguments[i] = difference(number(1), arguments[i]);
  } else {
    arguments[i] = choices.once_in(2) ? number(static_cast<long>(choices.below(2)))
                                      : difference(number(1), arguments[i]);
  }
  return apply(node->operands[0], arguments, node->type, derivative);
}

/// One small change at the root of an expression.
Node changed(const Node& node, Choices& choices, const Draft& draft) {
  switch (node->kind) {
    case Kind::number:
      return other_number(node, choices);
    case Kind::name:
      return other_name(node, choices, draft);
    case Kind::element:
      return other_element(node, choices, draft);
    case Kind::sum:
    case Kind::product:
      return other_operands(node, choices);
    case Kind::negative:
      return node->operands[0];
    case Kind::power:
      return power(node->operands[0], static_cast<unsigned>(std::stoul(node->text)) + 1);
    case Kind::apply:
      return other_application(node, choices);
    case Kind::quotient:
      return quotient(node->operands[0], negative(node->operands[1]));
    case Kind::integral:
      return integral(node->operands[0], node->text, node->operands[1],
                      sum({node->operands[2], number(1)}));
    case Kind::matrix: {
      std::vector<Node> entries = node->operands;
      std::swap(entries[0], entries[choices.below(entries.size())]);
      return with_operands(node, entries);
    }
    default:
      return negative(node);
  }
}

/// A polynomial, not zero, with many zeros.
Node vanishing_often(Choices& choices, const Draft& draft) {
  std::vector<Node> factors{random_number(choices)};
  if (draft.scalars.empty()) return factors[0];
  const Node x = choices.one_of(draft.scalars);
  factors.push_back(x);
  for (std::uint64_t k = choices.below(4); k > 0; --k)
    factors.push_back(difference(x, number(static_cast<long>(k))));
  if (choices.once_in(2)) factors.push_back(difference(product({number(2), x}), number(1)));
  if (choices.once_in(3)) factors.push_back(difference(x, choices.one_of(draft.scalars)));
  if (choices.once_in(3)) factors.push_back(choices.one_of(draft.scalars));
  return product(factors);
}

Node with_something_added(const Node& node, Choices& choices, const Draft& draft) {
  Node more = vanishing_often(choices, draft);
  if (node->type == Type::point) {
    if (draft.points.empty()) return negative(node);
    more = product({more, choices.one_of(draft.points)});
  }
  return choices.once_in(2) ? sum({node, more}) : difference(node, more);
}

bool differs(const Node& a, const Value& original, const Draft& draft) {
  try {
    return !same(meaning(a, draft.environment), original);
  } catch (const std::domain_error&) {
    return false;
  }
}

}  // namespace

Node near_miss(Choices& choices, const Draft& draft, const Node& node) {
  const Value original = meaning(node, draft.environment);
  for (unsigned attempt = 0; attempt < 8; ++attempt) {
    const std::vector<Node> all = places(node);
    const std::size_t place = choices.below(all.size());
    const bool add = choices.once_in(3) && all[place]->type != Type::matrix;
    const Node instead = add ? with_something_added(all[place], choices, draft)
                             : changed(all[place], choices, draft);
    if (instead->type != all[place]->type) continue;
    const Node candidate = with_place(node, place, instead);
    if (differs(candidate, original, draft)) return candidate;
  }
  const Node twice = product({number(2), node});
  if (differs(twice, original, draft)) return twice;
  if (node->type == Type::scalar) return sum({node, number(1)});
  if (!draft.points.empty() && node->type == Type::point) return sum({node, draft.points.front()});
  return nullptr;
}

}  // namespace patchproof::differential
