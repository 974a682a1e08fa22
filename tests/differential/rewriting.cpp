#include "rewriting.hpp"

#include <algorithm>

#include "places.hpp"

namespace patchproof::differential {
namespace {

/// Null where the rule does not apply.
using Rule = Node (*)(const Node&, Choices&, const Draft&);

bool is_function_name(const Node& node) {
  return node->kind == Kind::name && node->type == Type::function;
}

std::size_t count_not_scalar(const Node& node) {
  return static_cast<std::size_t>(
      std::count_if(node->operands.begin(), node->operands.end(),
                    [](const Node& operand) { return operand->type != Type::scalar; }));
}

Node random_like(const Node& node, Choices& choices, const Draft& draft) {
  if (node->type == Type::scalar) return random_scalar(choices, draft, 0);
  if (node->type == Type::point && !draft.points.empty()) return choices.one_of(draft.points);
  return node;
}

Node commuted(const Node& node, Choices& choices, const Draft&) {
  const bool is_product = node->kind == Kind::product && count_not_scalar(node) <= 1;
  if (node->kind != Kind::sum && !is_product) return nullptr;
  std::vector<Node> operands = node->operands;
  const std::size_t i = choices.below(operands.size());
  std::swap(operands[i], operands[(i + 1) % operands.size()]);
  return with_operands(node, operands);
}

Node distributed(const Node& node, Choices& choices, const Draft&) {
  if (node->kind == Kind::quotient && node->operands[0]->kind == Kind::sum) {
    std::vector<Node> terms;
    for (const Node& term : node->operands[0]->operands)
      terms.push_back(quotient(term, node->operands[1]));
    return sum(terms);
  }
  if (node->kind != Kind::product) return nullptr;
  const std::size_t start = choices.below(node->operands.size());
  for (std::size_t k = 0; k < node->operands.size(); ++k) {
    const std::size_t i = (start + k) % node->operands.size();
    if (node->operands[i]->kind != Kind::sum) continue;
    std::vector<Node> terms;
    for (const Node& term : node->operands[i]->operands) {
      std::vector<Node> factors = node->operands;
      factors[i] = term;
      terms.push_back(product(factors));
    }
    return sum(terms);
  }
  return nullptr;
}

Node regrouped(const Node& node, Choices& choices, const Draft&) {
  // Flatten, or put the first two together.
  if (node->kind != Kind::sum && node->kind != Kind::product) return nullptr;
  const auto made = [&](const std::vector<Node>& parts) {
    return node->kind == Kind::sum ? sum(parts) : product(parts);
  };
  if (choices.once_in(2) && node->operands.size() > 2) {
    std::vector<Node> rest(node->operands.begin() + 2, node->operands.end());
    rest.insert(rest.begin(), made({node->operands[0], node->operands[1]}));
    return made(rest);
  }
  std::vector<Node> flat;
  for (const Node& operand : node->operands)
    if (operand->kind == node->kind)
      flat.insert(flat.end(), operand->operands.begin(), operand->operands.end());
    else
      flat.push_back(operand);
  return made(flat);
}

Node power_split(const Node& node, Choices& choices, const Draft&) {
  if (node->kind != Kind::power) return nullptr;
  const auto exponent = static_cast<unsigned>(std::stoul(node->text));
  const Node& base = node->operands[0];
  if (exponent < 2) return base;
  if (exponent == 2 && base->kind == Kind::sum && base->operands.size() == 2 &&
      !choices.once_in(3)) {
    const Node& a = base->operands[0];
    const Node& b = base->operands[1];
    return sum({power(a, 2), product({number(2), a, b}), power(b, 2)});
  }
  return product({base, exponent == 2 ? base : power(base, exponent - 1)});
}

Node added_and_taken_away(const Node& node, Choices& choices, const Draft& draft) {
  if (node->type == Type::matrix) return nullptr;
  Node more = random_like(node, choices, draft);
  if (choices.once_in(2)) more = product({random_scalar(choices, draft, 0), more});
  return choices.once_in(2) ? sum({node, more, negative(more)})
                            : difference(sum({more, node}), more);
}

Node scaled(const Node& node, Choices& choices, const Draft& draft) {
  if (!draft.divisors.empty() && node->type != Type::matrix && choices.once_in(2)) {
    const Node& by = choices.one_of(draft.divisors);
    return quotient(product({by, node}), by);
  }
  const Node factor = random_number(choices);
  return product({quotient(number(1), factor), product({factor, node})});
}

Node split_in_two(const Node& node, Choices& choices, const Draft& draft) {
  const Node t = random_scalar(choices, draft, 0);
  return sum({product({difference(number(1), t), node}), product({t, node})});
}

Node sign_moved(const Node& node, Choices&, const Draft&) {
  if (node->kind == Kind::negative) return product({number(-1), node->operands[0]});
  if (node->kind == Kind::sum) {
    std::vector<Node> opposite;
    for (const Node& term : node->operands)
      opposite.push_back(term->kind == Kind::negative ? term->operands[0] : negative(term));
    return negative(sum(opposite));
  }
  if (node->kind == Kind::quotient)
    return quotient(negative(node->operands[0]), negative(node->operands[1]));
  return nullptr;
}

Node fraction_extended(const Node& node, Choices& choices, const Draft& draft) {
  if (node->kind != Kind::quotient || draft.divisors.empty()) return nullptr;
  const Node& by = choices.one_of(draft.divisors);
  return quotient(product({node->operands[0], by}), product({by, node->operands[1]}));
}

Node function_unfolded(const Node& node, Choices& choices, const Draft& draft) {
  if (node->kind != Kind::apply || !is_function_name(node->operands[0])) return nullptr;
  for (const DeclaredFunction& function : draft.functions) {
    if (function.name != node->operands[0]->text) continue;
    std::vector<Node> bodies;
    for (const Alternative& alternative : function.alternatives)
      if (alternative.derivative == node->derivative) bodies.push_back(alternative.body);
    if (bodies.empty()) return nullptr;
    return replaced(choices.one_of(bodies), [&](const std::string& name) -> Node {
      for (std::size_t i = 0; i < function.formals.size(); ++i)
        if (function.formals[i] == name) return node->operands[i + 1];
      return nullptr;
    });
  }
  return nullptr;
}

/// r_uv(u,v) = diff(r_u(u,v), v), and diff(r_u(u,v), v) by the rules.
Node derivative_rewritten(const Node& node, Choices&, const Draft& draft) {
  if (node->kind == Kind::call && node->text == "diff") {
    const Node result = derivative_written_out(node->operands[0], node->operands[1]->text, draft);
    // 0 is a number here, and a point is asked for.
    return result && result->type == node->type ? result : nullptr;
  }
  if (node->kind != Kind::apply || node->derivative.empty()) return nullptr;
  for (const DeclaredFunction& function : draft.functions) {
    if (function.name != node->operands[0]->text) continue;
    for (std::size_t i = 0; i < function.formals.size(); ++i)
      if (node->operands[i + 1]->text != function.formals[i] ||
          std::count(draft.parameters.begin(), draft.parameters.end(), function.formals[i]) == 0)
        return nullptr;
    const std::string last(1, node->derivative.back());
    const std::vector<Node> arguments(node->operands.begin() + 1, node->operands.end());
    const Node lower = apply(node->operands[0], arguments, node->type,
                             node->derivative.substr(0, node->derivative.size() - 1));
    return call("diff", {lower, scalar_name(last)}, node->type);
  }
  return nullptr;
}

Node integral_rewritten(const Node& node, Choices& choices, const Draft& draft) {
  if (node->kind != Kind::integral) return nullptr;
  const Node& body = node->operands[0];
  const Node& low = node->operands[1];
  const Node& high = node->operands[2];
  if (choices.once_in(3)) return negative(integral(negative(body), node->text, low, high));
  if (body->kind == Kind::sum && choices.once_in(2)) {
    std::vector<Node> terms;
    for (const Node& term : body->operands) terms.push_back(integral(term, node->text, low, high));
    return sum(terms);
  }
  const Node middle =
      choices.once_in(3) ? draft.scalars.back() : quotient(sum({low, high}), number(2));
  return sum({integral(body, node->text, low, middle), integral(body, node->text, middle, high)});
}

Node assumption_used(const Node& node, Choices& choices, const Draft& draft) {
  for (const auto& [name, value] : draft.assumed)
    if (node->kind == Kind::name && node->text == name) return value;
  if (draft.assumed.empty()) return nullptr;
  const auto& [name, value] = choices.one_of(draft.assumed);
  if (value->type != node->type && node->type != Type::point) return nullptr;
  const Node own = value->type == Type::point ? point_name(name) : scalar_name(name);
  const Node nothing = product({random_scalar(choices, draft, 0), difference(own, value)});
  if (nothing->type != node->type) return nullptr;
  return sum({node, nothing});
}

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all{commuted,
                                     distributed,
                                     distributed,
                                     regrouped,
                                     power_split,
                                     added_and_taken_away,
                                     scaled,
                                     split_in_two,
                                     sign_moved,
                                     fraction_extended,
                                     function_unfolded,
                                     function_unfolded,
                                     function_unfolded,
                                     derivative_rewritten,
                                     integral_rewritten,
                                     assumption_used};
  return all;
}

}  // namespace

Node rewritten(Choices& choices, const Draft& draft, Node node, unsigned steps) {
  for (unsigned attempt = 0; steps > 0 && attempt < 40; ++attempt) {
    const std::vector<Node> all = places(node);
    const std::size_t place = choices.below(all.size());
    const Node instead = choices.one_of(rules())(all[place], choices, draft);
    if (!instead || case_text(instead) == case_text(all[place])) continue;
    node = with_place(node, place, instead);
    --steps;
  }
  return node;
}

Node unfolded_somewhere(Choices& choices, const Draft& draft, const Node& node) {
  const std::vector<Node> all = places(node);
  const std::size_t start = choices.below(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t place = (start + k) % all.size();
    const Node instead = function_unfolded(all[place], choices, draft);
    if (instead) return with_place(node, place, instead);
  }
  return node;
}

}  // namespace patchproof::differential
