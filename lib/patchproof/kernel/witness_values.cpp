#include <patchproof/kernel/witness_values.hpp>

#include <algorithm>

#include <patchproof/kernel/frame.hpp>
#include <patchproof/kernel/interpolation.hpp>
#include <patchproof/kernel/polynomial_term.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

bool is_open(Variable variable, const Atoms& atoms) {
  const Atom::Kind kind = atoms[variable].kind;
  return kind == Atom::Kind::symbol || kind == Atom::Kind::jet;
}

Fraction with_value(const Fraction& fraction, Variable variable, const Rational& value,
                    Hypotheses& hypotheses, Workspace& workspace) {
  const Fraction reduced = hypotheses.reduced(fraction);
  return hypotheses.reduced(Substitution{{{variable, value}}, workspace}(reduced));
}

namespace {

class Values {
 public:
  Values(const Goal& goal, const Assignment& assigned, Variable known, Hypotheses& hypotheses,
         Workspace& workspace, bool uneven)
      : goal_{goal},
        assigned_{assigned},
        known_{known},
        hypotheses_{hypotheses},
        workspace_{workspace},
        uneven_{uneven} {}

  std::optional<Witness> collected() {
    Witness witness;
    std::map<unsigned, SymbolPointer> symbols = free_symbols(goal_);
    for (const ParameterRange& range : goal_.ranges) {
      const auto names_it = [&](const Statement& s) {
        return free_symbols(s.left).contains(range.parameter->ordinal) ||
               free_symbols(s.right).contains(range.parameter->ordinal);
      };
      // An inequality that is assumed restricts a parameter even where no statement names it.
      const bool needed =
          std::any_of(goal_.statements.begin(), goal_.statements.end(), names_it) ||
          std::any_of(goal_.assumptions.begin(), goal_.assumptions.end(), [&](const Assumption& a) {
            return a.statement.relation != Relation::equal && names_it(a.statement);
          });
      if (!needed) symbols.erase(range.parameter->ordinal);
    }
    for (const KnownValue& known : goal_.known) symbols.erase(known.symbol->ordinal);
    for (const auto& [ordinal, symbol] : symbols) {
      const std::optional<Term> value =
          symbol->role == Symbol::Role::function ? function(symbol) : constant(symbol);
      if (!value) return std::nullopt;
      witness.values.push_back({symbol, *value});
    }
    return witness;
  }

 private:
  // The value of a fraction once everything is assigned; what is still open is zero.
  std::optional<Rational> number(const Fraction& fraction) {
    Fraction result = hypotheses_.reduced(fraction);
    for (const auto& [v, value] : assigned_)
      result = with_value(result, v, value, hypotheses_, workspace_);
    for (int round = 0; round < 1000; ++round) {
      std::optional<Variable> open;
      std::set<Variable> within = variables_within(result.numerator(), workspace_.atoms);
      for (const auto& [factor, exponent] : result.denominator())
        within.merge(variables_within(factor, workspace_.atoms));
      for (const Variable v : within)
        if (is_open(v, workspace_.atoms)) open = v;
      if (!open) break;
      result = with_value(result, *open, 0, hypotheses_, workspace_);
    }
    if (!result.is_polynomial() || !result.numerator().is_constant()) return std::nullopt;
    return result.numerator().constant();
  }

  std::optional<Term> constant(const SymbolPointer& symbol) {
    std::vector<Term> coordinates;
    for (std::size_t k = 0; k < symbol->type.component_count(); ++k) {
      const Variable v = workspace_.atoms.symbol(symbol, static_cast<int>(k));
      const std::optional<Rational> value = number(Polynomial::variable(v));
      if (!value) return std::nullopt;
      coordinates.push_back(number_term(*value));
    }
    if (symbol->type.is_scalar()) return coordinates.front();
    return make_term(Operation::tuple, symbol->type, std::move(coordinates));
  }

  std::optional<Term> function(const SymbolPointer& symbol) {
    std::vector<Polynomial> components;
    std::vector<Variable> slots;
    for (std::size_t k = 0; k < symbol->type.parameters.size(); ++k)
      slots.push_back(workspace_.atoms.slot(symbol, static_cast<int>(k)));
    for (std::size_t c = 0; c < symbol->type.component_count(); ++c) {
      const std::optional<Polynomial> found = component(symbol, static_cast<int>(c), slots);
      if (!found) return std::nullopt;
      components.push_back(*found);
    }
    return polynomial_function(components, symbol->type, slots);
  }

  bool matters(Variable v) const {
    return v < known_ || std::any_of(assigned_.begin(), assigned_.end(),
                                     [&](const auto& value) { return value.first == v; });
  }

  bool is_assigned(Variable v) const {
    return std::any_of(assigned_.begin(), assigned_.end(),
                       [&](const auto& value) { return value.first == v; });
  }

  // Whether a value was tried for the function under an integral.
  bool is_under_integral(Variable jet) const {
    if (!is_assigned(jet)) return false;
    const Atom& atom = workspace_.atoms[jet];
    return std::any_of(atom.arguments.begin(), atom.arguments.end(), [&](const Fraction& argument) {
      const std::set<Variable> within = variables(argument);
      return std::any_of(within.begin(), within.end(), [&](Variable x) {
        return workspace_.atoms[x].kind == Atom::Kind::running;
      });
    });
  }

  // Such a value is meant for a place between the ends: the first or the second of two.
  Fraction sampled(const Fraction& argument, int place) {
    std::map<Variable, Fraction> places;
    for (const Variable v : variables(argument)) {
      const Atom atom = workspace_.atoms[v];
      if (atom.kind != Atom::Kind::running) continue;
      const Fraction length = difference(atom.arguments[1], atom.arguments[0], workspace_.budget);
      const Rational part{place, atom.component + 3};
      places.emplace(
          v, sum(atom.arguments[0], product(length, part, workspace_.budget), workspace_.budget));
    }
    return substituted(argument, places, workspace_.budget);
  }

  // What is asked of the function by the value of a jet; nothing when it is not at numbers.
  std::optional<Prescription> prescription(Variable v, int place) {
    const Atom atom = workspace_.atoms[v];
    Prescription result{atom.orders, {}, 0};
    for (const Fraction& given : atom.arguments) {
      const Fraction argument = is_assigned(v) ? sampled(given, place) : given;
      for (const Variable x : variables(argument)) {
        const Atom& inner = workspace_.atoms[x];
        const bool bound = inner.kind == Atom::Kind::slot || inner.kind == Atom::Kind::running ||
                           (inner.symbol && inner.symbol->role == Symbol::Role::bound);
        if (bound) return std::nullopt;
      }
      const std::optional<Rational> at = number(argument);
      if (!at) return std::nullopt;
      result.at.push_back(*at);
    }
    const std::optional<Rational> value = number(Polynomial::variable(v));
    if (!value) return std::nullopt;
    result.value = *value * (place == 1 ? 1 : 3);
    return result;
  }

  // A polynomial with the values assumed on edges, and one that vanishes there.
  std::optional<Frame> frame(const SymbolPointer& symbol, int c,
                             const std::vector<Variable>& slots) {
    Frame result{Polynomial{}, Polynomial{Rational{1}}};
    for (const Hypotheses::EdgeValue& edge : hypotheses_.edges(*symbol, c)) {
      std::vector<Variable> along;
      EdgePolynomial part;
      for (std::size_t k = 0; k < slots.size(); ++k) {
        if (!edge.fixed[k]) {
          along.push_back(slots[k]);
          continue;
        }
        part.slot = slots[k];
        part.at = *edge.fixed[k];
        part.order = edge.orders[k];
      }
      const std::optional<Polynomial> value = defined_component(edge.definition, along);
      if (!value) return std::nullopt;
      part.value = *value;
      add_edge(part, result, workspace_.budget);
    }
    return result;
  }

  // The unknown function as a polynomial in its slots, through all the values it must have.
  std::optional<Polynomial> component(const SymbolPointer& symbol, int c,
                                      const std::vector<Variable>& slots) {
    const auto key = std::pair{symbol->ordinal, c};
    const auto known = functions_.find(key);
    if (known != functions_.end()) return known->second;
    if (const auto defined = hypotheses_.definition(*symbol, c)) {
      const std::optional<Polynomial> value = defined_component(*defined, slots);
      if (value) functions_.emplace(key, *value);
      return value;
    }
    std::vector<Prescription> prescriptions;
    for (Variable v = 0; v < workspace_.atoms.size(); ++v) {
      const Atom atom = workspace_.atoms[v];
      if (atom.kind != Atom::Kind::jet || atom.symbol->ordinal != symbol->ordinal ||
          atom.component != c || !matters(v))
        continue;
      for (const int place : {1, 2}) {
        if (place == 2 && !(uneven_ && is_under_integral(v))) break;
        std::optional<Prescription> p = prescription(v, place);
        if (p) prescriptions.push_back(std::move(*p));
      }
    }
    const std::optional<Frame> around = frame(symbol, c, slots);
    if (!around) return std::nullopt;
    std::optional<Polynomial> result =
        around->vanishing.is_constant()
            ? interpolant(prescriptions, slots, workspace_.budget)
            : framed_interpolant(prescriptions, *around, slots, workspace_.budget);
    if (result) functions_.emplace(key, *result);
    return result;
  }

  // A function that the assumptions define by others, at the polynomials chosen for those.
  std::optional<Polynomial> defined_component(const Hypotheses::Definition& definition,
                                              const std::vector<Variable>& slots) {
    std::map<Variable, Fraction> images;
    std::set<Variable> within = variables_within(definition.value.numerator(), workspace_.atoms);
    for (const auto& [factor, exponent] : definition.value.denominator())
      within.merge(variables_within(factor, workspace_.atoms));
    for (const Variable v : within) {
      const Atom atom = workspace_.atoms[v];
      if (atom.kind == Atom::Kind::symbol && atom.symbol->role != Symbol::Role::parameter) {
        const std::optional<Rational> value = number(Polynomial::variable(v));
        if (!value) return std::nullopt;
        images.emplace(v, *value);
      } else if (atom.kind == Atom::Kind::jet) {
        std::vector<Variable> inner;
        for (std::size_t k = 0; k < atom.arguments.size(); ++k)
          inner.push_back(workspace_.atoms.slot(atom.symbol, static_cast<int>(k)));
        std::optional<Polynomial> value = component(atom.symbol, atom.component, inner);
        if (!value) return std::nullopt;
        std::map<Variable, Fraction> arguments;
        for (std::size_t k = 0; k < inner.size(); ++k) {
          for (int order = 0; order < atom.orders[k]; ++order) value = derivative(*value, inner[k]);
          arguments.emplace(inner[k], atom.arguments[k]);
        }
        images.emplace(v, substituted(Fraction{*value}, arguments, workspace_.budget));
      }
    }
    // Also under integrals, which then are those of polynomials.
    Fraction value = Substitution{std::move(images), workspace_}(definition.value);
    std::map<Variable, Fraction> rename;
    for (std::size_t k = 0; k < slots.size(); ++k)
      rename.emplace(definition.parameters[k], Fraction{Polynomial::variable(slots[k])});
    value = substituted(value, rename, workspace_.budget);
    if (!value.is_polynomial()) return std::nullopt;
    const std::set<Variable> allowed{slots.begin(), slots.end()};
    for (const Variable v : value.numerator().variables())
      if (!allowed.contains(v)) return std::nullopt;
    return value.numerator();
  }

  const Goal& goal_;
  const Assignment& assigned_;
  Variable known_;
  Hypotheses& hypotheses_;
  Workspace& workspace_;
  bool uneven_;
  std::map<std::pair<unsigned, int>, Polynomial> functions_;
};

}  // namespace

std::optional<Witness> witness_values(const Goal& goal, const Assignment& assignment,
                                      Variable known, Hypotheses& hypotheses, Workspace& workspace,
                                      int attempt) {
  return Values{goal, assignment, known, hypotheses, workspace, attempt % 2 == 1}.collected();
}

}  // namespace patchproof
