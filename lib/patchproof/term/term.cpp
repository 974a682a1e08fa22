#include <patchproof/term/term.hpp>

#include <algorithm>
#include <utility>

namespace patchproof {

Term make_term(Operation operation, Type type, std::vector<Term> children,
               TermNode::Payload payload, Span span) {
  int depth = 0;
  for (const Term& child : children) {
    if (!child) throw std::logic_error{"a term with an empty child"};
    depth = std::max(depth, child->depth);
  }
  if (depth >= deepest_term) {
    throw TooDeep{"this expression is nested more than " + std::to_string(deepest_term) +
                  " levels deep"};
  }
  TermNode node{operation,          std::move(type), std::move(children),
                std::move(payload), std::move(span), depth + 1};
  return Term{std::make_shared<const TermNode>(std::move(node))};
}

bool is_one_term(const Term& a, const Term& b) {
  if (a.address() == b.address()) return true;
  return !a.children().empty() && a.operation() == b.operation() && a.type() == b.type() &&
         std::equal(a.children().begin(), a.children().end(), b.children().begin(),
                    b.children().end(),
                    [](const Term& x, const Term& y) { return x.address() == y.address(); });
}

Term number_term(const Rational& number, Span span) {
  return make_term(Operation::number, Type::scalar(), {}, number, std::move(span));
}

Term symbol_term(const SymbolPointer& symbol, Span span) {
  return make_term(Operation::symbol, symbol->type, {}, symbol, std::move(span));
}

}  // namespace patchproof
