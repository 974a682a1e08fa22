#include <patchproof/term/replacement.hpp>

#include <unordered_map>

namespace patchproof {

namespace {

using Symbols = std::map<unsigned, SymbolPointer>;

class Collector {
 public:
  const Symbols& of(const Term& term) {
    const auto known = known_.find(term.address());
    if (known != known_.end()) return known->second;
    Symbols result;
    if (term.operation() == Operation::symbol) result.emplace(term.symbol()->ordinal, term.symbol());
    for (const Term& child : term.children()) {
      const Symbols& inner = of(child);
      result.insert(inner.begin(), inner.end());
    }
    if (term.operation() == Operation::lambda)
      for (const SymbolPointer& formal : term.formals()) result.erase(formal->ordinal);
    return known_.emplace(term.address(), std::move(result)).first->second;
  }

 private:
  std::unordered_map<const TermNode*, Symbols> known_;
};

class Replacer {
 public:
  explicit Replacer(const std::map<unsigned, Term>& images) : images_{images} {}

  Term of(const Term& term) {
    const auto known = known_.find(term.address());
    if (known != known_.end()) return known->second;
    return known_.emplace(term.address(), compute(term)).first->second;
  }

 private:
  Term compute(const Term& term) {
    if (term.operation() == Operation::symbol) {
      const auto image = images_.find(term.symbol()->ordinal);
      return image == images_.end() ? term : image->second;
    }
    if (term.operation() == Operation::lambda) {
      std::map<unsigned, Term> inside = images_;
      for (const SymbolPointer& formal : term.formals()) inside.erase(formal->ordinal);
      if (inside.size() != images_.size()) {
        const Term body = Replacer{inside}.of(term.child(0));
        return make_term(Operation::lambda, term.type(), {body}, term->payload, term.span());
      }
    }
    std::vector<Term> children;
    bool changed = false;
    for (const Term& child : term.children()) {
      children.push_back(of(child));
      changed = changed || children.back().address() != child.address();
    }
    if (!changed) return term;
    return make_term(term.operation(), term.type(), std::move(children), term->payload,
                     term.span());
  }

  const std::map<unsigned, Term>& images_;
  std::unordered_map<const TermNode*, Term> known_;
};

}  // namespace

Symbols free_symbols(const Term& term) { return Collector{}.of(term); }

Symbols free_symbols(const Goal& goal) {
  Collector collector;
  Symbols result;
  const auto add = [&](const Term& term) {
    const Symbols& inner = collector.of(term);
    result.insert(inner.begin(), inner.end());
  };
  for (const Statement& s : goal.statements) add(s.left), add(s.right);
  for (const Assumption& a : goal.assumptions) add(a.statement.left), add(a.statement.right);
  for (const ParameterRange& r : goal.ranges) add(r.lower), add(r.upper);
  for (const KnownValue& k : goal.known) add(k.value);
  return result;
}

Term replaced(const Term& term, const std::map<unsigned, Term>& images) {
  if (images.empty()) return term;
  return Replacer{images}.of(term);
}

}  // namespace patchproof
