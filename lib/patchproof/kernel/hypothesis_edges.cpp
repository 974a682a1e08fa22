#include <algorithm>

#include <patchproof/kernel/hypotheses.hpp>

namespace patchproof {

namespace {

std::optional<Rational> constant_of(const Fraction& fraction) {
  if (!fraction.is_polynomial() || !fraction.numerator().is_constant()) return std::nullopt;
  return fraction.numerator().constant();
}

std::optional<Variable> bare_variable(const Fraction& fraction) {
  const std::set<Variable> its = variables(fraction);
  if (its.size() != 1 || !fraction.is_polynomial()) return std::nullopt;
  if (!(fraction.numerator() == Polynomial::variable(*its.begin()))) return std::nullopt;
  return *its.begin();
}

}  // namespace

bool Hypotheses::are_in_range(const std::vector<Variable>& parameters,
                              const std::vector<Fraction>& arguments) const {
  std::map<Variable, Fraction> moved;
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (bare_variable(arguments[k]) != parameters[k]) moved.emplace(parameters[k], arguments[k]);
  Substitution at_arguments{moved, workspace_};
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    const auto range = ranges_.find(parameters[k]);
    if (range == ranges_.end()) continue;
    const Fraction low = at_arguments(range->second.low);
    const Fraction high = at_arguments(range->second.high);
    const bool ends_stay = !(low < range->second.low) && !(range->second.low < low) &&
                           !(high < range->second.high) && !(range->second.high < high);
    if (ends_stay && !moved.contains(parameters[k])) continue;
    // The variable of an integral runs between its ends, in whichever order they are.
    const std::optional<Variable> bare = bare_variable(arguments[k]);
    const bool running = bare && workspace_.atoms[*bare].kind == Atom::Kind::running;
    const std::vector<Fraction> places =
        running ? workspace_.atoms[*bare].arguments : std::vector<Fraction>{arguments[k]};
    const bool inside = std::all_of(places.begin(), places.end(), [&](const Fraction& place) {
      const Fraction above = difference(place, low, workspace_.budget);
      const Fraction below = difference(high, place, workspace_.budget);
      return above.is_polynomial() && below.is_polynomial() &&
             facts_.never_negative(above.numerator(), workspace_.budget) &&
             facts_.never_negative(below.numerator(), workspace_.budget);
    });
    if (!inside) return false;
  }
  return true;
}

// r(u,0) = ... for all u: r occurs once, at numbers and at all the bare parameters.
bool Hypotheses::define_edge(const Polynomial& equation) {
  const std::set<Variable> parameters = parameters_in(equation);
  const std::set<Variable> within = variables_within(equation, workspace_.atoms);
  std::optional<Variable> best;
  EdgeValue found;
  for (const Variable v : equation.variables()) {
    const Atom& atom = workspace_.atoms[v];
    if (atom.kind != Atom::Kind::jet || equation.degree(v) != 1) continue;
    const std::vector<Polynomial> parts = coefficients(equation, v);
    if (!parts[1].is_constant()) continue;
    EdgeValue edge;
    edge.orders = atom.orders;
    std::set<Variable> along;
    bool fits = true;
    for (std::size_t k = 0; k < atom.arguments.size(); ++k) {
      edge.fixed.push_back(constant_of(atom.arguments[k]));
      if (edge.fixed.back()) continue;
      const std::optional<Variable> bare = bare_variable(atom.arguments[k]);
      fits = fits && bare && atom.orders[k] == 0 && parameters.contains(*bare) &&
             along.insert(*bare).second;
      if (fits) edge.definition.parameters.push_back(*bare);
    }
    if (!fits || along != parameters) continue;
    const bool alone = std::none_of(within.begin(), within.end(), [&](Variable other) {
      const Atom& o = workspace_.atoms[other];
      return other != v && o.kind == Atom::Kind::jet && o.symbol->ordinal == atom.symbol->ordinal &&
             o.component == atom.component;
    });
    const bool later = !best || workspace_.atoms[*best].symbol->ordinal < atom.symbol->ordinal;
    if (!alone || !later) continue;
    best = v;
    edge.definition.value = scaled(parts[0], Rational{-1} / parts[1].constant());
    found = std::move(edge);
  }
  if (!best) return false;
  const Atom& atom = workspace_.atoms[*best];
  edges_[{atom.symbol->ordinal, atom.component}].push_back(std::move(found));
  function_images_.clear();
  return true;
}

std::vector<Hypotheses::EdgeValue> Hypotheses::edges(const Symbol& function, int component) const {
  const auto known = edges_.find({function.ordinal, component});
  return known == edges_.end() ? std::vector<EdgeValue>{} : known->second;
}

std::optional<Fraction> Hypotheses::edge_value(const Atom& jet) {
  const auto known = edges_.find({jet.symbol->ordinal, jet.component});
  if (known == edges_.end()) return std::nullopt;
  for (const EdgeValue& edge : known->second) {
    // Brought to the form of a function of the arguments along the edge.
    Atom along = jet;
    along.orders.clear();
    along.arguments.clear();
    bool fits = true;
    for (std::size_t k = 0; k < jet.arguments.size(); ++k) {
      if (edge.fixed[k]) {
        fits = fits && jet.orders[k] == edge.orders[k] &&
               constant_of(jet.arguments[k]) == edge.fixed[k];
        continue;
      }
      along.orders.push_back(jet.orders[k]);
      along.arguments.push_back(jet.arguments[k]);
    }
    if (!fits || !are_in_range(edge.definition.parameters, along.arguments)) continue;
    try {
      return function_value(edge.definition, along);
    } catch (const std::domain_error&) {
      continue;  // the value is not assumed to have that derivative
    }
  }
  return std::nullopt;
}

}  // namespace patchproof
