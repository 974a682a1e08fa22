#include <patchproof/kernel/hypotheses.hpp>

#include <algorithm>

namespace patchproof {

namespace {

constexpr int most_rounds = 24;

bool is_parameter(const Atom& atom) {
  return atom.kind == Atom::Kind::symbol && atom.symbol->role == Symbol::Role::parameter;
}

void collect(const Fraction& fraction, const Atoms& atoms, std::set<Variable>& result) {
  for (const Variable v : variables(fraction)) {
    if (!result.insert(v).second) continue;
    for (const Fraction& argument : atoms[v].arguments) collect(argument, atoms, result);
  }
}

bool same(const Fraction& a, const Fraction& b) { return !(a < b) && !(b < a); }

}  // namespace

std::set<Variable> variables_within(const Polynomial& polynomial, const Atoms& atoms) {
  std::set<Variable> result;
  collect(Fraction{polynomial}, atoms, result);
  return result;
}

Hypotheses::Hypotheses(const Goal& goal, const std::vector<bool>& enabled, Evaluator& evaluator,
                       Workspace& workspace)
    : workspace_{workspace} {
  add_ranges(goal, evaluator);
  find_restricted(goal, enabled, evaluator);
  for (std::size_t k = 0; k < goal.assumptions.size(); ++k) {
    const Statement& statement = goal.assumptions[k].statement;
    if (!enabled[k] || statement.relation != Relation::equal) continue;
    const std::string& label = goal.assumptions[k].label;
    const std::string name = label.empty() ? "an assumption" : "assumption '" + label + "'";
    const Value left = evaluator.value(statement.left);
    const Value right = evaluator.value(statement.right);
    conditions_.insert(left.conditions.begin(), left.conditions.end());
    conditions_.insert(right.conditions.begin(), right.conditions.end());
    for (std::size_t c = 0; c < left.components.size(); ++c) {
      const Fraction both =
          normal_form(difference(left.components[c], right.components[c], workspace_.budget),
                      workspace_);
      add_equation(both.numerator(), name);
    }
  }
  add_facts(goal, enabled, evaluator);
  contradictory_ = contradictory_ || facts_.contradictory(workspace_.budget);
}

void Hypotheses::add_equation(const Polynomial& equation, const std::string& name) {
  const Polynomial rest = reduced(Fraction{equation}).numerator();
  if (rest.is_zero()) return;
  if (rest.is_constant()) {
    contradictory_ = true;
    return;
  }
  const std::set<Variable> named = parameters_in(rest);
  const auto held_back = std::find_if(named.begin(), named.end(),
                                      [&](Variable v) { return ordered_.contains(v); });
  if (held_back != named.end()) {
    left_out_.push_back(name + " holds only where the assumed inequalities do, which restrict '" +
                        workspace_.atoms[*held_back].symbol->name + "'");
    unsolved_.push_back(rest);
    return;
  }
  const bool solved = named.empty()
                          ? replace_variable(rest)
                          : define_function(rest) || define_edge(rest) ||
                                split_by_parameters(rest, name);
  if (solved) return;
  left_out_.push_back(name + " is not linear in something it could be solved for");
  unsolved_.push_back(rest);
}

std::set<Variable> Hypotheses::parameters_in(const Polynomial& polynomial) const {
  std::set<Variable> result;
  for (const Variable v : variables_within(polynomial, workspace_.atoms))
    if (is_parameter(workspace_.atoms[v])) result.insert(v);
  return result;
}

// F(u) = ... for all u: F occurs once, at the bare parameters, and is not on the other side.
bool Hypotheses::define_function(const Polynomial& equation) {
  const std::set<Variable> parameters = parameters_in(equation);
  const std::set<Variable> within = variables_within(equation, workspace_.atoms);
  std::optional<Variable> best;
  for (const Variable v : equation.variables()) {
    const Atom& atom = workspace_.atoms[v];
    if (atom.kind != Atom::Kind::jet || equation.degree(v) != 1) continue;
    if (!coefficients(equation, v)[1].is_constant()) continue;
    if (std::any_of(atom.orders.begin(), atom.orders.end(), [](int k) { return k != 0; })) continue;
    std::set<Variable> arguments;
    bool bare = true;
    for (const Fraction& argument : atom.arguments) {
      const std::set<Variable> its = variables(argument);
      bare = bare && its.size() == 1 && parameters.contains(*its.begin()) &&
             same(argument, Fraction{Polynomial::variable(*its.begin())}) &&
             arguments.insert(*its.begin()).second;
    }
    if (!bare || arguments != parameters) continue;
    const bool alone = std::none_of(within.begin(), within.end(), [&](Variable other) {
      const Atom& o = workspace_.atoms[other];
      return other != v && o.kind == Atom::Kind::jet && o.symbol->ordinal == atom.symbol->ordinal &&
             o.component == atom.component;
    });
    if (!alone) continue;
    if (!best || workspace_.atoms[*best].symbol->ordinal < atom.symbol->ordinal) best = v;
  }
  if (!best) return false;
  const Atom& atom = workspace_.atoms[*best];
  const std::vector<Polynomial> parts = coefficients(equation, *best);
  Definition definition;
  for (const Fraction& argument : atom.arguments)
    definition.parameters.push_back(*variables(argument).begin());
  definition.value = scaled(parts[0], Rational{-1} / parts[1].constant());
  functions_.emplace(std::pair{atom.symbol->ordinal, atom.component}, std::move(definition));
  function_images_.clear();
  return true;
}

// A polynomial in parameters that vanishes for all of them has vanishing coefficients; that needs
// intervals that are more than a point, and parameters that occur nowhere else.
bool Hypotheses::split_by_parameters(const Polynomial& equation, const std::string& name) {
  const std::set<Variable> parameters = parameters_in(equation);
  std::map<Monomial, std::vector<Polynomial::Term>> parts;
  for (const auto& term : equation.terms()) {
    Monomial inside;
    Monomial outside;
    for (const auto& p : term.monomial.powers()) {
      const bool bare = parameters.contains(p.variable);
      if (!bare) {
        const Polynomial alone = Polynomial::variable(p.variable);
        if (!parameters_in(alone).empty()) return false;
      }
      Monomial& part = bare ? inside : outside;
      part = part * Monomial{p.variable, p.exponent};
    }
    parts[inside].push_back({outside, term.coefficient});
  }
  for (const Variable v : parameters) {
    const auto range = ranges_.find(v);
    if (range == ranges_.end()) continue;
    const Fraction length = difference(range->second.high, range->second.low, workspace_.budget);
    if (!length.is_polynomial() || !length.numerator().is_constant() ||
        length.numerator().constant() <= 0)
      return false;
  }
  for (auto& [inside, terms] : parts) add_equation(Polynomial::from_terms(std::move(terms)), name);
  return true;
}

// The symbol declared last is expressed by the others.
bool Hypotheses::replace_variable(const Polynomial& equation) {
  std::optional<Variable> best;
  const auto rank = [&](Variable v) {
    const Atom& atom = workspace_.atoms[v];
    return std::tuple{atom.symbol->ordinal, v};
  };
  std::set<Variable> inside_arguments;
  for (const Variable v : equation.variables())
    for (const Fraction& argument : workspace_.atoms[v].arguments)
      collect(argument, workspace_.atoms, inside_arguments);
  for (const Variable v : equation.variables()) {
    const Atom& atom = workspace_.atoms[v];
    if (atom.kind != Atom::Kind::symbol && atom.kind != Atom::Kind::jet) continue;
    if (equation.degree(v) != 1 || !coefficients(equation, v)[1].is_constant()) continue;
    if (inside_arguments.contains(v)) continue;
    if (!best || rank(*best) < rank(v)) best = v;
  }
  if (!best) return false;
  const std::vector<Polynomial> parts = coefficients(equation, *best);
  const Fraction value = scaled(parts[0], Rational{-1} / parts[1].constant());
  images_.emplace(*best, value);
  for (auto& [variable, image] : images_) {
    if (variable == *best) continue;
    image = Substitution{{{*best, value}}, workspace_}(image);
  }
  function_images_.clear();
  return true;
}

std::optional<Hypotheses::Definition> Hypotheses::definition(const Symbol& function,
                                                             int component) const {
  const auto found = functions_.find({function.ordinal, component});
  if (found == functions_.end()) return std::nullopt;
  return found->second;
}

Fraction Hypotheses::function_value(const Definition& definition, const Atom& jet) {
  if (!are_in_range(definition.parameters, jet.arguments))
    throw OutsideTheory{
        "an assumption about a function is known only for parameters in their range"};
  Fraction result = definition.value;
  std::map<Variable, Fraction> arguments;
  const bool differentiated =
      std::any_of(jet.orders.begin(), jet.orders.end(), [](int order) { return order > 0; });
  for (std::size_t k = 0; k < definition.parameters.size(); ++k) {
    // Known on the diagonal only, v in [u, u], a function may have any derivative in u.
    const Variable parameter = definition.parameters[k];
    if (jet.orders[k] > 0 || (differentiated && has_dependent_range(parameter)))
      require_proper_range(parameter);
    for (int order = 0; order < jet.orders[k]; ++order)
      result = derivative(result, definition.parameters[k], conditions_, workspace_);
    arguments.emplace(definition.parameters[k], jet.arguments[k]);
  }
  Substitution substitution{std::move(arguments), workspace_};
  result = substitution(result);
  conditions_.insert(substitution.conditions().begin(), substitution.conditions().end());
  return result;
}

std::map<Variable, Fraction> Hypotheses::images_for(const Fraction& fraction) {
  std::map<Variable, Fraction> result = images_;
  if (functions_.empty() && edges_.empty()) return result;
  std::set<Variable> within;
  collect(fraction, workspace_.atoms, within);
  for (const Variable v : within) {
    const Atom atom = workspace_.atoms[v];
    if (atom.kind != Atom::Kind::jet) continue;
    const auto definition = functions_.find({atom.symbol->ordinal, atom.component});
    if (definition == functions_.end()) {
      if (const std::optional<Fraction> value = edge_value(atom)) result.insert_or_assign(v, *value);
      continue;
    }
    const auto known = function_images_.find(v);
    result.insert_or_assign(
        v, known != function_images_.end()
               ? known->second
               : function_images_.emplace(v, function_value(definition->second, atom)).first->second);
  }
  return result;
}

Fraction Hypotheses::reduced(const Fraction& fraction) {
  Fraction result = fraction;
  for (int round = 0; round < most_rounds; ++round) {
    std::map<Variable, Fraction> images = images_for(result);
    if (images.empty()) return result;
    Substitution substitution{std::move(images), workspace_};
    const Fraction next = substitution(result);
    conditions_.insert(substitution.conditions().begin(), substitution.conditions().end());
    if (same(next, result)) return result;
    result = next;
  }
  throw OutsideTheory{"assumptions that define things by each other without end"};
}

}  // namespace patchproof
