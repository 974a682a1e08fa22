#include <patchproof/certificate/equation_search.hpp>

#include <algorithm>

#include <patchproof/certificate/sequents.hpp>
#include <patchproof/kernel/hypotheses.hpp>
#include <patchproof/kernel/polynomial_term.hpp>
#include <patchproof/kernel/transformation.hpp>

namespace patchproof {

namespace {

// More instances than this are not looked at.
constexpr std::size_t most_instances = 400;

bool is_parameter(const Atom& atom) {
  return atom.kind == Atom::Kind::symbol && atom.symbol->role == Symbol::Role::parameter;
}

// Whether one of the given variables occurs, perhaps in an argument of a function.
bool mentions(const Fraction& fraction, const std::vector<Variable>& among, const Atoms& atoms) {
  const std::set<Variable> within = variables_within(fraction.numerator(), atoms);
  return std::any_of(among.begin(), among.end(), [&](Variable v) { return within.contains(v); });
}

}  // namespace

EquationSearch::EquationSearch(const Sequent& sequent, const std::set<unsigned>& unknowns,
                               Evaluator& evaluator, Workspace& workspace)
    : sequent_{sequent}, unknowns_{unknowns}, workspace_{workspace} {
  std::set<unsigned> restricted;
  for (const Assumption& hypothesis : sequent.hypotheses)
    if (hypothesis.statement.relation != Relation::equal)
      for (const SymbolPointer& parameter : parameters_of(hypothesis.statement))
        restricted.insert(parameter->ordinal);
  for (std::size_t k = 0; k < sequent.hypotheses.size(); ++k) {
    const Statement& statement = sequent.hypotheses[k].statement;
    if (statement.relation != Relation::equal) continue;
    const Value left = evaluator.value(statement.left);
    const Value right = evaluator.value(statement.right);
    conditions_.insert(left.conditions.begin(), left.conditions.end());
    conditions_.insert(right.conditions.begin(), right.conditions.end());
    for (std::size_t c = 0; c < left.components.size(); ++c) {
      Equation equation{k, c,
                        normal_form(difference(left.components[c], right.components[c],
                                               workspace.budget),
                                    workspace),
                        {},
                        false};
      if (equation.difference.is_zero()) continue;
      for (const SymbolPointer& parameter : parameters_of(statement)) {
        equation.parameters.push_back(workspace.atoms.symbol(parameter));
        equation.restricted = equation.restricted || restricted.contains(parameter->ordinal);
      }
      equations_.push_back(std::move(equation));
    }
  }
  for (const Equation& equation : equations_)
    if (equation.parameters.empty()) add(equation, {}, {});
}

// Instances are numbered in the order they are made; each becomes a row at once.
void EquationSearch::add(const Equation& equation, const std::vector<std::optional<Fraction>>& at,
                         const std::vector<int>& orders) {
  if (chosen_.size() >= most_instances) return;
  Chosen chosen{&equation, {}, orders, equation.difference};
  chosen.orders.resize(equation.parameters.size(), 0);
  std::map<Variable, Fraction> images;
  for (std::size_t k = 0; k < equation.parameters.size(); ++k) {
    const Fraction parameter{Polynomial::variable(equation.parameters[k])};
    const Fraction value = at.at(k).value_or(parameter);
    const bool itself = !(value < parameter) && !(parameter < value);
    if (equation.restricted && (!itself || chosen.orders[k] > 0)) return;
    chosen.at.push_back(value);
    if (!itself) images.emplace(equation.parameters[k], value);
  }
  std::vector<Fraction> key = chosen.at;
  for (const int order : chosen.orders) key.push_back(Rational{order});
  const auto index = static_cast<std::size_t>(&equation - equations_.data());
  if (!tried_.insert({index, key}).second) return;
  try {
    for (std::size_t k = 0; k < chosen.orders.size(); ++k)
      for (int order = 0; order < chosen.orders[k]; ++order)
        chosen.difference =
            derivative(chosen.difference, equation.parameters[k], conditions_, workspace_);
    Substitution substitution{images, workspace_};
    chosen.difference = normal_form(substitution(chosen.difference), workspace_);
    for (const Condition& condition : substitution.conditions()) conditions_.insert(condition);
  } catch (const std::domain_error&) {
    return;  // a derivative that is not assumed to exist, a divisor that vanishes there
  }
  for (const auto& [factor, exponent] : chosen.difference.denominator())
    conditions_.insert({Condition::Kind::not_zero, factor});
  if (chosen.difference.is_zero()) return;
  chosen_.push_back(std::move(chosen));
  add_row(chosen_.size() - 1);
}

void EquationSearch::add_row(std::size_t chosen) {
  Reduced state{chosen_[chosen].difference.numerator(), {{chosen, Polynomial{Rational{-1}}}}};
  // rest = numerator - multiples; as a combination that is zero: rest = sum of multiples.
  reduce(state);
  if (state.rest.is_zero()) return;
  for (auto& [index, factor] : state.multiples) factor = scaled(factor, -1);
  if (std::optional<Row> row = row_of(state)) rows_.push_back(std::move(*row));
}

std::optional<EquationSearch::Row> EquationSearch::row_of(const Reduced& combination) const {
  std::optional<Row> best;
  std::vector<int> best_rank;
  for (const Variable v : combination.rest.variables()) {
    const Atom& atom = workspace_.atoms[v];
    if (is_parameter(atom)) continue;
    if (atom.kind != Atom::Kind::symbol && atom.kind != Atom::Kind::jet) continue;
    const unsigned degree = combination.rest.degree(v);
    const std::vector<Polynomial> parts = coefficients(combination.rest, v);
    if (!parts.back().is_constant()) continue;
    const bool unknown = atom.symbol && unknowns_.contains(atom.symbol->ordinal);
    int order = 0;
    for (const int o : atom.orders) order += o;
    const std::vector<int> rank{degree == 1, unknown, atom.kind == Atom::Kind::jet, order,
                                static_cast<int>(v)};
    if (best && rank <= best_rank) continue;
    best = Row{combination, v, degree};
    best_rank = rank;
  }
  return best;
}

// rest = polynomial - sum of multiples of instances, at every moment.
void EquationSearch::reduce(Reduced& state) {
  Budget& budget = workspace_.budget;
  for (const Row& row : rows_) {
    const Polynomial& divisor = row.combination.rest;
    const Rational lead = coefficients(divisor, row.pivot).back().constant();
    while (state.rest.degree(row.pivot) >= row.degree) {
      const std::vector<Polynomial> parts = coefficients(state.rest, row.pivot);
      const auto excess = static_cast<unsigned>(parts.size() - 1) - row.degree;
      Polynomial quotient = scaled(parts.back(), 1 / lead);
      if (excess > 0)
        quotient = product(quotient,
                           power(Polynomial::variable(row.pivot), excess, budget), budget);
      state.rest = normal_form(difference(state.rest, product(quotient, divisor, budget), budget),
                               workspace_);
      for (const auto& [index, factor] : row.combination.multiples) {
        Polynomial& total = state.multiples[index];
        total = sum(total, product(quotient, factor, budget), budget);
      }
    }
  }
}

EquationSearch::Reduced EquationSearch::reduced(const Polynomial& polynomial) {
  for (int round = 0;; ++round) {
    Reduced state{polynomial, {}};
    reduce(state);
    const std::size_t before = chosen_.size();
    if (state.rest.is_zero() || round == 6) return state;
    choose_for(polynomial);
    choose_for(state.rest);
    if (chosen_.size() == before) return state;
  }
}

void EquationSearch::choose_for(const Polynomial& polynomial) {
  for (const Equation& equation : equations_)
    if (!equation.parameters.empty() && !equation.restricted) sample(equation);
  for (const Variable v : polynomial.variables()) {
    const Atom atom = workspace_.atoms[v];
    if (atom.kind == Atom::Kind::jet) choose_at_values_of(atom);
  }
  for (const Equation& equation : equations_)
    if (equation.restricted)
      add(equation, std::vector<std::optional<Fraction>>(equation.parameters.size()), {});
}

// An equation whose functions are all given at fixed arguments holds at as many places as its degree
// asks for.
void EquationSearch::sample(const Equation& equation) {
  const Polynomial& p = equation.difference.numerator();
  for (const Variable v : p.variables()) {
    const Atom& atom = workspace_.atoms[v];
    for (const Fraction& argument : atom.arguments)
      if (mentions(argument, equation.parameters, workspace_.atoms)) return;
  }
  if (!equation.difference.is_polynomial()) return;
  std::vector<std::vector<Fraction>> places{{}};
  for (const Variable parameter : equation.parameters) {
    std::optional<Rational> low;
    std::optional<Rational> high;
    for (const ParameterRange& range : sequent_.ranges) {
      if (workspace_.atoms[parameter].symbol->ordinal != range.parameter->ordinal) continue;
      if (!range.lower.is_number() || !range.upper.is_number()) return;
      low = range.lower.number();
      high = range.upper.number();
    }
    const unsigned degree = p.degree(parameter);
    if (!low) low = 0, high = std::max(1U, degree);
    if (*low == *high && degree > 0) return;
    std::vector<std::vector<Fraction>> next;
    for (const std::vector<Fraction>& place : places)
      for (unsigned k = 0; k <= degree; ++k) {
        next.push_back(place);
        next.back().emplace_back(degree == 0 ? *low : *low + (*high - *low) * k / degree);
      }
    places = std::move(next);
    if (places.size() > most_instances) return;
  }
  for (const std::vector<Fraction>& place : places)
    add(equation, {place.begin(), place.end()}, {});
}

namespace {

// What the parameters have to be so that the argument becomes the value: `at` is filled in. False
// when that is impossible.
bool matched(const Fraction& argument, const Fraction& value, const std::vector<Variable>& parameters,
             std::vector<std::optional<Fraction>>& at, std::optional<std::size_t>& bound,
             Workspace& workspace) {
  const auto same = [](const Fraction& a, const Fraction& b) { return !(a < b) && !(b < a); };
  if (!argument.is_polynomial()) return false;
  const Polynomial& p = argument.numerator();
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (p.degree(parameters[k]) > 0) {
      if (bound || p.degree(parameters[k]) > 1) return false;
      bound = k;
    }
  if (!bound) return same(argument, value);
  const std::vector<Polynomial> parts = coefficients(p, parameters[*bound]);
  if (!parts.back().is_constant()) return false;
  const Fraction image = product(difference(value, Fraction{parts.front()}, workspace.budget),
                                 Fraction{1 / parts.back().constant()}, workspace.budget);
  std::optional<Fraction>& place = at[*bound];
  if (place && !same(*place, image)) return false;
  place = image;
  return true;
}

}  // namespace

void EquationSearch::choose_at_values_of(const Atom& jet) {
  for (std::size_t e = 0; e < equations_.size(); ++e) {
    const Equation& equation = equations_[e];
    if (equation.parameters.empty() || equation.restricted) continue;
    for (const Variable v : equation.difference.numerator().variables()) {
      const Atom own = workspace_.atoms[v];
      if (own.kind != Atom::Kind::jet || own.symbol->ordinal != jet.symbol->ordinal ||
          own.component != jet.component)
        continue;
      std::vector<std::optional<Fraction>> at(equation.parameters.size());
      std::vector<int> orders(equation.parameters.size(), 0);
      bool fits = true;
      for (std::size_t k = 0; k < own.arguments.size() && fits; ++k) {
        std::optional<std::size_t> bound;
        fits = matched(own.arguments[k], jet.arguments[k], equation.parameters, at, bound, workspace_);
        const int more = jet.orders[k] - own.orders[k];
        fits = fits && more >= 0 && (more == 0 || bound);
        if (fits && more > 0) orders[*bound] += more;
      }
      if (fits) add(equation, at, orders);
    }
  }
}

std::vector<Cofactor> EquationSearch::cofactors(
    const std::map<std::size_t, Polynomial>& multiples, const Fraction& difference) {
  std::vector<Cofactor> result;
  for (const auto& [index, factor] : multiples) {
    const Polynomial plain = normal_form(factor, workspace_);
    if (plain.is_zero()) continue;
    const Chosen& chosen = chosen_[index];
    Instance instance{chosen.equation->hypothesis, chosen.equation->component, {}, chosen.orders};
    for (const Fraction& value : chosen.at)
      instance.at.push_back(scalar_term(value, workspace_.atoms));
    const Polynomial above =
        product(plain, expanded(chosen.difference.denominator(), workspace_.budget),
                workspace_.budget);
    const Fraction multiple{above, difference.denominator(), workspace_.budget};
    result.push_back({std::move(instance), scalar_term(multiple, workspace_.atoms)});
  }
  return result;
}

}  // namespace patchproof
