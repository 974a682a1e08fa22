#include <patchproof/certificate/derivative_orders.hpp>

#include <algorithm>

#include <patchproof/term/replacement.hpp>

namespace patchproof {

void DerivativeOrders::note(const Term& term) {
  if (!noted_.insert(term.address()).second) return;
  if (term.operation() == Operation::derivative)
    for (const auto& [ordinal, symbol] : free_symbols(term))
      if (symbol->role == Symbol::Role::function)
        orders_[ordinal] = std::max(orders_[ordinal], in(term));
  for (const Term& child : term.children()) note(child);
}

int DerivativeOrders::of(const SymbolPointer& function) const {
  const auto found = orders_.find(function->ordinal);
  return found == orders_.end() ? 0 : found->second;
}

int DerivativeOrders::in(const Term& term) {
  const auto found = all_.find(term.address());
  if (found != all_.end()) return found->second;
  int deepest = 0;
  for (const Term& child : term.children()) deepest = std::max(deepest, in(child));
  if (term.operation() == Operation::derivative)
    for (const int order : term.indices()) deepest += order;
  return all_[term.address()] = deepest;
}

}  // namespace patchproof
