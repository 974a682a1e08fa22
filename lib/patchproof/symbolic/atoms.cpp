#include <patchproof/symbolic/atoms.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace patchproof::symbolic {

namespace {

bool same_arguments(const Atom& a, const Atom& b) {
  if (a.arguments.size() != b.arguments.size() || a.divisor != b.divisor) return false;
  for (std::size_t i = 0; i < a.arguments.size(); ++i) {
    if (!a.arguments[i].is_equal(b.arguments[i])) return false;
  }
  return true;
}

bool has_relations(Atom::Kind kind) {
  return kind == Atom::Kind::inverse || kind == Atom::Kind::root || kind == Atom::Kind::exponential;
}

void collect(const Atoms& atoms, const GiNaC::ex& expression, std::set<unsigned>& found) {
  if (GiNaC::is_a<GiNaC::symbol>(expression)) found.insert(atoms.id_of(expression));
  for (std::size_t i = 0; i < expression.nops(); ++i) collect(atoms, expression.op(i), found);
}

}  // namespace

const GiNaC::ex& Atoms::symbol_for(const Atom& atom) {
  const unsigned ordinal = atom.symbol ? atom.symbol->ordinal : 0;
  std::vector<unsigned>& candidates =
      by_key_[Key{atom.kind, ordinal, atom.component, atom.orders, atom.imaginary}];
  for (const unsigned id : candidates) {
    if (same_arguments(entries_[id].atom, atom)) return entries_[id].symbol;
  }
  const unsigned id = static_cast<unsigned>(entries_.size());
  std::set<unsigned> within{id};
  for (const GiNaC::ex& argument : atom.arguments) within.merge(occurring_deeply(argument));
  const bool is_related = std::any_of(within.begin(), within.end(), [&](unsigned inner) {
    return inner != id && has_relations(entries_[inner].atom.kind);
  });
  entries_.push_back({atom, GiNaC::symbol{}, std::move(within), is_related});
  ids_.emplace(entries_.back().symbol, id);
  candidates.push_back(id);
  if (atom.kind == Atom::Kind::root) has_roots_ = true;
  return entries_.back().symbol;
}

unsigned Atoms::id_of(const GiNaC::ex& symbol) const {
  const auto found = ids_.find(symbol);
  if (found == ids_.end()) throw std::logic_error{"an expression that is not made of atoms"};
  return found->second;
}

std::set<unsigned> Atoms::occurring(const GiNaC::ex& expression) const {
  std::set<unsigned> found;
  collect(*this, expression, found);
  return found;
}

std::set<unsigned> Atoms::occurring_deeply(const GiNaC::ex& expression) const {
  std::set<unsigned> found;
  for (const unsigned id : occurring(expression)) {
    found.insert(within(id).begin(), within(id).end());
  }
  return found;
}

}  // namespace patchproof::symbolic
