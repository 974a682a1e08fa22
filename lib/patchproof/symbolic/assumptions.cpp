#include <patchproof/symbolic/assumptions.hpp>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include <patchproof/symbolic/normal_form.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::numeric;
using Kind = Atom::Kind;

bool is_parameter(const Atom& atom) {
  return atom.kind == Kind::letter && atom.symbol->role == Symbol::Role::parameter;
}

// equation == coefficient*atom + rest, where the rest is free of the atom.
struct Solved {
  numeric coefficient;
  ex rest;
};

std::optional<Solved> solved_for(const Ring& ring, const ex& equation, unsigned id) {
  std::vector<Summand> others;
  std::optional<numeric> coefficient;
  for (const Summand& part : summands(equation, ring.atoms())) {
    if (part.powers == Powers{{id, 1}}) {
      coefficient = part.coefficient;
    } else {
      others.push_back(part);
    }
  }
  if (!coefficient) return std::nullopt;
  const ex rest = polynomial(others, ring.atoms());
  if (ring.atoms().occurring_deeply(rest).contains(id)) return std::nullopt;
  return Solved{*coefficient, rest};
}

// The parameters u, v of an undifferentiated F(u, v); nothing for any other atom.
std::optional<std::vector<unsigned>> formals(const Ring& ring, const Atom& atom) {
  if (atom.kind != Kind::jet) return std::nullopt;
  std::vector<unsigned> result;
  for (const ex& argument : atom.arguments) {
    if (!GiNaC::is_a<GiNaC::symbol>(argument)) return std::nullopt;
    const unsigned id = ring.atoms().id_of(argument);
    const bool is_new = std::find(result.begin(), result.end(), id) == result.end();
    if (!is_parameter(ring.atoms().at(id)) || !is_new) return std::nullopt;
    result.push_back(id);
  }
  const bool is_plain =
      std::all_of(atom.orders.begin(), atom.orders.end(), [](int order) { return order == 0; });
  if (!is_plain) return std::nullopt;
  return result;
}

bool has_function(const Ring& ring, const ex& expression, const Atom& jet) {
  const std::set<unsigned> ids = ring.atoms().occurring_deeply(expression);
  return std::any_of(ids.begin(), ids.end(), [&](unsigned id) {
    const Atom& atom = ring.atoms().at(id);
    return atom.kind == Kind::jet && atom.symbol->ordinal == jet.symbol->ordinal &&
           atom.component == jet.component;
  });
}

bool has_only_parameters(const Ring& ring, const ex& expression,
                         const std::vector<unsigned>& allowed) {
  const std::set<unsigned> ids = ring.atoms().occurring_deeply(expression);
  return std::none_of(ids.begin(), ids.end(), [&](unsigned id) {
    return is_parameter(ring.atoms().at(id)) &&
           std::find(allowed.begin(), allowed.end(), id) == allowed.end();
  });
}

}  // namespace

bool has_parameters(const Ring& ring, unsigned atom) {
  const std::set<unsigned>& ids = ring.atoms().within(atom);
  return std::any_of(ids.begin(), ids.end(),
                     [&](unsigned id) { return is_parameter(ring.atoms().at(id)); });
}

bool has_parameters(const Ring& ring, const ex& expression) {
  const std::set<unsigned> ids = ring.atoms().occurring(expression);
  return std::any_of(ids.begin(), ids.end(), [&](unsigned id) { return has_parameters(ring, id); });
}

Assumptions::Assumptions(Ring& ring, Evaluation& evaluation,
                         const std::vector<Assumption>& assumptions, const std::set<unsigned>& kept)
    : ring_{ring}, kept_{kept} {
  for (const Assumption& assumption : assumptions) {
    if (assumption.statement.relation != Relation::equal) continue;
    const Components& left = evaluation(assumption.statement.left).components;
    const Components& right = evaluation(assumption.statement.right).components;
    const Components differences = sum(ring_, {left, scaled(ring_, right, -1)});
    for (const ex& difference : differences) add_equation(difference);
  }
  split_by_parameters();
  while (use_any()) split_by_parameters();
  are_all_used_ = equations_.empty();
}

void Assumptions::add_equation(const ex& equation) {
  const ex form = normal_form(ring_, equation);
  if (form.is_zero()) return;
  if (GiNaC::is_a<numeric>(form)) {
    throw std::domain_error{"the assumptions contradict each other"};
  }
  equations_.push_back(form);
}

// What holds for all u as a polynomial in u holds for its coefficients.
void Assumptions::split_by_parameters() {
  const std::vector<ex> before = std::exchange(equations_, {});
  for (const ex& equation : before) {
    const std::set<unsigned> ids = ring_.atoms().occurring(equation);
    const bool is_polynomial = std::all_of(ids.begin(), ids.end(), [&](unsigned id) {
      return is_parameter(ring_.atoms().at(id)) || !has_parameters(ring_, id);
    });
    if (!is_polynomial) {
      equations_.push_back(equation);
      continue;
    }
    const auto chosen = [this](unsigned id) { return is_parameter(ring_.atoms().at(id)); };
    for (const auto& [powers, coefficient] : coefficients(equation, ring_.atoms(), chosen)) {
      add_equation(coefficient);
    }
  }
}

void Assumptions::use(Replacements replacements) {
  rules_.emplace_back(ring_, std::move(replacements));
  const std::vector<ex> before = std::exchange(equations_, {});
  for (const ex& equation : before) add_equation(rules_.back()(equation));
}

bool Assumptions::has_kept(const ex& equation) const {
  const std::set<unsigned> ids = ring_.atoms().occurring_deeply(equation);
  return std::any_of(ids.begin(), ids.end(), [this](unsigned id) {
    const SymbolPointer& symbol = ring_.atoms().at(id).symbol;
    return symbol && kept_.contains(symbol->ordinal);
  });
}

bool Assumptions::use_for_function(std::size_t index) {
  const ex equation = equations_[index];
  if (has_kept(equation)) return false;
  for (const unsigned id : ring_.atoms().occurring(equation)) {
    const Atom& atom = ring_.atoms().at(id);
    const std::optional<std::vector<unsigned>> parameters = formals(ring_, atom);
    const std::optional<Solved> solved = solved_for(ring_, equation, id);
    if (!parameters || !solved || has_function(ring_, solved->rest, atom)) continue;
    if (!has_only_parameters(ring_, solved->rest, *parameters)) continue;
    equations_.erase(equations_.begin() + static_cast<std::ptrdiff_t>(index));
    Replacements replacements;
    replacements.functions[{atom.symbol->ordinal, atom.component}] = {
        *parameters, solved->rest / -solved->coefficient};
    use(std::move(replacements));
    return true;
  }
  return false;
}

bool Assumptions::use_for_atom(std::size_t index, Kind kind) {
  const ex equation = equations_[index];
  if (has_parameters(ring_, equation) || has_kept(equation)) return false;
  const std::set<unsigned> ids = ring_.atoms().occurring(equation);
  for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
    const Atom& atom = ring_.atoms().at(*id);
    if (atom.kind != kind) continue;
    // C(a) was replaced and a now should be: that C(b) has a value too would be missed.
    if (fixed_.contains(*id)) continue;
    const std::optional<Solved> solved = solved_for(ring_, equation, *id);
    if (!solved) continue;
    if (kind == Kind::jet)
      fixed_.insert(ring_.atoms().within(*id).begin(), ring_.atoms().within(*id).end());
    equations_.erase(equations_.begin() + static_cast<std::ptrdiff_t>(index));
    Replacements replacements;
    replacements.atoms[*id] = solved->rest / -solved->coefficient;
    use(std::move(replacements));
    return true;
  }
  return false;
}

// Functions before symbols before values of functions: each can change the arguments of the next.
bool Assumptions::use_any() {
  for (std::size_t i = 0; i < equations_.size(); ++i) {
    if (use_for_function(i)) return true;
  }
  for (const Kind kind : {Kind::letter, Kind::jet}) {
    for (std::size_t i = 0; i < equations_.size(); ++i) {
      if (use_for_atom(i, kind)) return true;
    }
  }
  return false;
}

ex Assumptions::operator()(ex polynomial) {
  for (Substitution& rule : rules_) polynomial = rule(polynomial);
  return polynomial;
}

}  // namespace patchproof::symbolic
