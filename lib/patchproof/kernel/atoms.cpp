#include <patchproof/kernel/atoms.hpp>

namespace patchproof {

bool operator<(const Atom& a, const Atom& b) {
  if (a.kind != b.kind) return a.kind < b.kind;
  const auto identity = [](const Atom& atom) { return atom.symbol ? atom.symbol->ordinal + 1 : 0; };
  if (identity(a) != identity(b)) return identity(a) < identity(b);
  return std::tie(a.component, a.orders, a.arguments) <
         std::tie(b.component, b.orders, b.arguments);
}

Variable Atoms::variable(const Atom& atom) {
  const auto next = static_cast<Variable>(atoms_.size());
  const auto [place, fresh] = variables_.try_emplace(atom, next);
  if (fresh) {
    atoms_.push_back(atom);
    has_relations_ =
        has_relations_ || atom.kind == Atom::Kind::sine || atom.kind == Atom::Kind::root;
  }
  return place->second;
}

Variable Atoms::symbol(const SymbolPointer& symbol, int component) {
  return variable({Atom::Kind::symbol, symbol, component, {}, {}});
}

Variable Atoms::slot(const SymbolPointer& function, int argument) {
  return variable({Atom::Kind::slot, function, argument, {}, {}});
}

}  // namespace patchproof
