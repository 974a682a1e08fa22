#include <patchproof/kernel/arrangement.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace patchproof {

namespace {

bool is_parameter(const Atom& atom) {
  if (atom.kind == Atom::Kind::slot) return true;
  return atom.kind == Atom::Kind::symbol && (atom.symbol->role == Symbol::Role::parameter ||
                                             atom.symbol->role == Symbol::Role::bound);
}

}  // namespace

bool Arrangement::earlier(Variable a, Variable b) const {
  if (a == b) return false;
  const Atom& x = atoms_[a];
  const Atom& y = atoms_[b];
  const auto ordinal = [](const Atom& atom) { return atom.symbol ? atom.symbol->ordinal : ~0U; };
  if (ordinal(x) != ordinal(y)) return ordinal(x) < ordinal(y);
  if (x.kind != y.kind) return x.kind < y.kind;
  if (x.component != y.component) return x.component < y.component;
  if (x.orders != y.orders) return x.orders < y.orders;
  return name_(a) < name_(b);
}

std::vector<Monomial::Power> Arrangement::powers(const Monomial& monomial) const {
  std::vector<Monomial::Power> result(monomial.powers().begin(), monomial.powers().end());
  std::sort(result.begin(), result.end(),
            [&](const auto& x, const auto& y) { return earlier(x.variable, y.variable); });
  return result;
}

bool Arrangement::before(const Monomial& a, const Monomial& b) const {
  const auto x = powers(a);
  const auto y = powers(b);
  for (std::size_t k = 0; k < std::min(x.size(), y.size()); ++k) {
    if (x[k].variable != y[k].variable) return earlier(x[k].variable, y[k].variable);
    if (x[k].exponent != y[k].exponent) return x[k].exponent > y[k].exponent;
  }
  return x.size() > y.size();
}

std::vector<Polynomial::Term> Arrangement::terms(const Polynomial& polynomial) const {
  std::vector<Polynomial::Term> result = polynomial.terms();
  std::sort(result.begin(), result.end(),
            [&](const auto& a, const auto& b) { return before(a.monomial, b.monomial); });
  return result;
}

std::vector<Arrangement::Group> Arrangement::groups(const Polynomial& polynomial) const {
  std::vector<std::pair<Monomial, std::vector<Polynomial::Term>>> parts;
  std::map<Monomial, std::size_t> places;
  for (const auto& term : polynomial.terms()) {
    Monomial unknowns;
    Monomial parameters;
    for (const auto& power : term.monomial.powers()) {
      Monomial& part = is_parameter(atoms_[power.variable]) ? parameters : unknowns;
      part = part * Monomial{power.variable, power.exponent};
    }
    const auto [place, fresh] = places.try_emplace(unknowns, parts.size());
    if (fresh) parts.push_back({unknowns, {}});
    parts[place->second].second.push_back({parameters, term.coefficient});
  }
  std::sort(parts.begin(), parts.end(),
            [&](const auto& a, const auto& b) { return before(a.first, b.first); });
  std::vector<Group> result;
  for (auto& [unknowns, coefficient] : parts)
    result.push_back({unknowns, Polynomial::from_terms(std::move(coefficient))});
  return result;
}

Arrangement::Factored Arrangement::factored(const Polynomial& coefficient) const {
  Factored result;
  result.rest = coefficient;
  const auto take_out = [&](const Polynomial& factor) {
    unsigned exponent = 0;
    while (std::optional<Polynomial> shorter = quotient(result.rest, factor, budget_)) {
      result.rest = std::move(*shorter);
      ++exponent;
    }
    if (exponent > 0) result.factors.push_back({factor, exponent});
  };
  const std::set<Variable> variables = coefficient.variables();
  std::vector<Variable> ordered(variables.begin(), variables.end());
  std::sort(ordered.begin(), ordered.end(), [&](Variable a, Variable b) { return earlier(a, b); });
  for (const Variable v : ordered) {
    take_out(Polynomial::variable(v));
    take_out(Polynomial::from_terms({{Monomial{}, 1}, {Monomial{v}, -1}}));
  }
  result.number = content(result.rest);
  result.negative = terms(result.rest).front().coefficient < 0;
  result.rest = scaled(result.rest, (result.negative ? -1 : 1) / result.number);
  return result;
}

}  // namespace patchproof
