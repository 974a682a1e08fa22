#include <algorithm>
#include <patchproof/kernel/interpolation.hpp>
#include <patchproof/kernel/polynomial_term.hpp>
#include <patchproof/kernel/witness.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

// Small numbers first; every interval has some of them sooner or later.
std::vector<Rational> candidates(int attempt) {
  static const std::vector<Rational> simple = [] {
    std::vector<Rational> result{0, 1, -1, Rational{1, 2}, 2, -2, Rational{1, 3}, Rational{2, 3},
                                 3, -3, Rational{1, 4}, Rational{3, 4}, Rational{-1, 2}};
    for (int n = 4; n <= 12; ++n) {
      result.push_back(n);
      result.push_back(-n);
      result.push_back(Rational{1, n + 1});
      result.push_back(Rational{n, n + 1});
      result.push_back(Rational{2, 2 * n - 3});
    }
    return result;
  }();
  std::vector<Rational> result = simple;
  const auto shift = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(attempt) % simple.size());
  std::rotate(result.begin(), result.begin() + shift, result.end());
  return result;
}

class Search {
 public:
  Search(const Goal& goal, const WitnessTarget& target, Hypotheses& hypotheses,
         Workspace& workspace, int attempt)
      : goal_{goal},
        target_{target},
        hypotheses_{hypotheses},
        workspace_{workspace},
        candidates_{candidates(attempt)} {}

  std::optional<Witness> run() {
    for (const Polynomial& p : target_.not_zero) state_.push_back({p, Kind::not_zero});
    for (const Polynomial& p : hypotheses_.facts().not_zero()) state_.push_back({p, Kind::not_zero});
    for (const auto& i : target_.inequalities) add_inequality(i);
    for (const auto& i : hypotheses_.facts().inequalities()) add_inequality(i);
    if (!assign()) return std::nullopt;
    return collected();
  }

 private:
  enum class Kind { not_zero, at_least_zero, above_zero };
  struct Requirement {
    Polynomial polynomial;
    Kind kind;
  };
  using State = std::vector<Requirement>;

  void add_inequality(const SignFacts::Inequality& i) {
    state_.push_back({i.polynomial, i.strict ? Kind::above_zero : Kind::at_least_zero});
  }

  bool is_base(Variable v) const {
    const Atom::Kind kind = workspace_.atoms[v].kind;
    return kind == Atom::Kind::symbol || kind == Atom::Kind::jet;
  }

  // Parameters and scalars come first: they occur in the arguments of others.
  std::optional<Variable> next_variable() const {
    std::optional<Variable> best;
    const auto rank = [&](Variable v) {
      const Atom& atom = workspace_.atoms[v];
      const bool scalar = atom.kind == Atom::Kind::symbol && atom.symbol->type.is_scalar();
      return std::tuple{!scalar, atom.symbol->ordinal, v};
    };
    for (const Requirement& requirement : state_)
      for (const Variable v : variables_within(requirement.polynomial, workspace_.atoms))
        if (is_base(v) && (!best || rank(v) < rank(*best))) best = v;
    return best;
  }

  Fraction with_value(const Fraction& fraction, Variable v, const Rational& value) {
    return hypotheses_.reduced(Substitution{{{v, value}}, workspace_}(hypotheses_.reduced(fraction)));
  }

  // The state after v = value; empty when some requirement then fails.
  std::optional<State> after(Variable v, const Rational& value) {
    State result;
    std::vector<LinearConstraint> linear;
    for (const Requirement& requirement : state_) {
      Polynomial p = requirement.polynomial;
      if (variables_within(p, workspace_.atoms).contains(v)) {
        const Fraction moved = with_value(p, v, value);
        if (!moved.is_polynomial()) return std::nullopt;
        p = moved.numerator();
      }
      if (p.is_constant()) {
        const Rational c = p.constant();
        const bool good = requirement.kind == Kind::not_zero        ? c != 0
                          : requirement.kind == Kind::at_least_zero ? c >= 0
                                                                    : c > 0;
        if (!good) return std::nullopt;
        continue;
      }
      if (requirement.kind != Kind::not_zero) {
        const auto constraint = linear_constraint(
            p, requirement.kind == Kind::above_zero ? LinearConstraint::Kind::above_zero
                                                    : LinearConstraint::Kind::at_least_zero);
        if (constraint && linear.size() < 24) linear.push_back(*constraint);
      }
      result.push_back({p, requirement.kind});
    }
    if (!linear.empty() && !small_model(linear, workspace_.budget)) return std::nullopt;
    return result;
  }

  bool assign() {
    const std::optional<Variable> v = next_variable();
    if (!v) return true;
    std::vector<Rational> values = candidates_;
    if (const std::optional<Rational> fitting = model_value(*v)) values.push_back(*fitting);
    for (const Rational& value : values) {
      if (++tried_ > 4000) return false;
      workspace_.budget.spend(10);
      std::optional<State> next;
      try {
        next = after(*v, value);
      } catch (const std::domain_error&) {
        continue;  // a division by zero: not a place to look at
      }
      if (!next) continue;
      std::swap(state_, *next);
      assigned_.emplace_back(*v, value);
      if (assign()) return true;
      assigned_.pop_back();
      std::swap(state_, *next);
    }
    return false;
  }

  // A value from a common solution of the linear requirements, for narrow or far intervals.
  std::optional<Rational> model_value(Variable v) {
    std::vector<LinearConstraint> linear;
    for (const Requirement& requirement : state_) {
      if (requirement.kind == Kind::not_zero || linear.size() >= 24) continue;
      const auto constraint = linear_constraint(requirement.polynomial,
                                                requirement.kind == Kind::above_zero
                                                    ? LinearConstraint::Kind::above_zero
                                                    : LinearConstraint::Kind::at_least_zero);
      if (constraint) linear.push_back(*constraint);
    }
    const auto model = small_model(linear, workspace_.budget);
    if (!model || !model->contains(v)) return std::nullopt;
    return model->at(v);
  }

  // The value of a fraction once everything is assigned; what is still open is zero.
  std::optional<Rational> number(const Fraction& fraction) {
    Fraction result = hypotheses_.reduced(fraction);
    for (const auto& [v, value] : assigned_) result = with_value(result, v, value);
    for (int round = 0; round < 1000; ++round) {
      std::optional<Variable> open;
      std::set<Variable> within = variables_within(result.numerator(), workspace_.atoms);
      for (const auto& [factor, exponent] : result.denominator())
        within.merge(variables_within(factor, workspace_.atoms));
      for (const Variable v : within)
        if (is_base(v)) open = v;
      if (!open) break;
      result = with_value(result, *open, 0);
    }
    if (!result.is_polynomial() || !result.numerator().is_constant()) return std::nullopt;
    return result.numerator().constant();
  }

  std::optional<Witness> collected() {
    Witness witness;
    std::map<unsigned, SymbolPointer> symbols = free_symbols(goal_);
    for (const ParameterRange& range : goal_.ranges) {
      const bool needed = std::any_of(
          goal_.statements.begin(), goal_.statements.end(), [&](const Statement& s) {
            return free_symbols(s.left).contains(range.parameter->ordinal) ||
                   free_symbols(s.right).contains(range.parameter->ordinal);
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
          atom.component != c)
        continue;
      Prescription p{atom.orders, {}, 0};
      bool numeric = true;
      for (const Fraction& argument : atom.arguments) {
        bool has_slot = false;
        for (const Variable x : variables(argument))
          has_slot = has_slot || workspace_.atoms[x].kind == Atom::Kind::slot ||
                     (workspace_.atoms[x].symbol &&
                      workspace_.atoms[x].symbol->role == Symbol::Role::bound);
        const std::optional<Rational> value = has_slot ? std::nullopt : number(argument);
        numeric = numeric && value.has_value();
        if (numeric) p.at.push_back(*value);
      }
      if (!numeric) continue;
      const std::optional<Rational> value = number(Polynomial::variable(v));
      if (!value) continue;
      p.value = *value;
      prescriptions.push_back(std::move(p));
    }
    std::optional<Polynomial> result = interpolant(prescriptions, slots, workspace_.budget);
    if (result) functions_.emplace(key, *result);
    return result;
  }

  // A function that the assumptions define by others, at the polynomials chosen for those.
  std::optional<Polynomial> defined_component(const Hypotheses::Definition& definition,
                                              const std::vector<Variable>& slots) {
    std::map<Variable, Fraction> images;
    for (const Variable v : variables(definition.value)) {
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
          for (int order = 0; order < atom.orders[k]; ++order)
            value = derivative(*value, inner[k]);
          arguments.emplace(inner[k], atom.arguments[k]);
        }
        images.emplace(v, substituted(Fraction{*value}, arguments, workspace_.budget));
      }
    }
    Fraction value = substituted(definition.value, images, workspace_.budget);
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
  const WitnessTarget& target_;
  Hypotheses& hypotheses_;
  Workspace& workspace_;
  std::vector<Rational> candidates_;
  State state_;
  std::vector<std::pair<Variable, Rational>> assigned_;
  std::map<std::pair<unsigned, int>, Polynomial> functions_;
  int tried_ = 0;
};

}  // namespace

std::optional<Witness> find_witness(const Goal& goal, const WitnessTarget& target,
                                    Hypotheses& hypotheses, Workspace& workspace, int attempt) {
  return Search{goal, target, hypotheses, workspace, attempt}.run();
}

}  // namespace patchproof
