#include <algorithm>

#include <patchproof/language/case_elaborator.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

bool contains(const Term& term, const std::vector<SymbolPointer>& symbols) {
  const std::map<unsigned, SymbolPointer> within = free_symbols(term);
  return std::any_of(symbols.begin(), symbols.end(),
                     [&](const SymbolPointer& s) { return within.contains(s->ordinal); });
}

// The control points of the competitor: all that is free in it.
std::vector<SymbolPointer> control_points_of(const Term& competitor, const syntax::Name& name) {
  std::vector<SymbolPointer> result;
  for (const auto& [ordinal, symbol] : free_symbols(competitor)) {
    if (symbol->role == Symbol::Role::function)
      throw Fault{name.span, "'" + name.text + "' is not given by control points",
                  "a competitor is polynomial, as in 'patch p(u, v) in R^3 : degree (3, 3)'"};
    if (symbol->role == Symbol::Role::point || symbol->role == Symbol::Role::scalar)
      result.push_back(symbol);
  }
  if (result.empty())
    throw Fault{name.span, "there is nothing free in '" + name.text + "'",
                "a competitor has unknown control points, as in 'patch p(u, v) : degree (3, 3)'"};
  return result;
}

}  // namespace

MinimumClaim CaseElaborator::minimum(const syntax::Minimum& minimum, const Scope& scope) {
  Construction& construct = elaborator_.construct();
  MinimumGoal result;
  const syntax::Name& name = minimum.competitor;
  const Term competitor = elaborator_.name(name.text, name.span, scope);
  result.unknowns = control_points_of(competitor, name);
  Term candidate = elaborator_.expression(*minimum.candidate, scope);
  if (contains(candidate, result.unknowns))
    throw Fault{minimum.candidate->span,
                "the candidate contains control points of the competitor '" + name.text + "'"};
  if (competitor.type().is_function() && !candidate.type().is_function()) {
    Formals formals;
    for (const std::string& parameter : competitor.type().parameters) {
      const Entity* entity = scope.find(parameter);
      if (entity == nullptr || entity->kind != Entity::Kind::term ||
          entity->term.operation() != Operation::symbol)
        throw Fault{minimum.candidate->span, "the candidate has to be a " +
                                                 to_text(competitor.type()) + ", not a " +
                                                 to_text(candidate.type())};
      formals.push_back(entity->term.symbol());
    }
    candidate = construct.lambda(formals, decayed(candidate), candidate.span());
  }

  Goal members;
  members.ranges = ranges_;
  add_relation(competitor, Relation::equal, candidate, minimum.span, scope, members);
  result.membership = members.statements.front();
  Goal constraints;
  constraints.ranges = members.ranges;
  for (const syntax::Comparison& comparison : minimum.constraints)
    add_comparison(comparison, scope, constraints);
  result.goal.ranges = constraints.ranges;
  for (const Assumption& assumption : assumptions_) {
    const Statement& s = assumption.statement;
    if (contains(s.left, result.unknowns) || contains(s.right, result.unknowns))
      constraints.statements.push_back(s);
    else
      result.goal.assumptions.push_back(assumption);
  }
  for (const Statement& s : constraints.statements)
    if (s.relation != Relation::equal)
      throw Fault{s.span, "competitors are restricted by equations, written '=='"};
  result.constraints = std::move(constraints.statements);

  Scope at_candidate{&scope};
  at_candidate.declare(name.text, candidate);
  const auto value = [&](const Scope& where) {
    const Term term = elaborator_.expression(*minimum.functional, where);
    const Term scalar = decayed(construct.value(where, term));
    if (!scalar.type().is_scalar())
      throw Fault{minimum.functional->span,
                  "what is minimized has to be a scalar, not a " + to_text(scalar.type())};
    return scalar;
  };
  const Term there = value(scope);
  if (!contains(there, result.unknowns))
    throw Fault{minimum.functional->span,
                "this functional does not depend on the competitor '" + name.text + "'"};
  for (const auto& [ordinal, symbol] : free_symbols(there))
    if (symbol->role == Symbol::Role::parameter)
      throw Fault{minimum.functional->span,
                  "what is minimized contains the parameter '" + symbol->name +
                      "', so that it is no number",
                  "minimize an integral, or the value at one place"};
  const Term here = value(at_candidate);
  if (contains(here, result.unknowns))
    throw Fault{minimum.functional->span,
                "this functional contains control points of '" + name.text +
                    "' other than by its name, so that its value at the candidate is not clear"};
  result.goal.statements = {{here, Relation::less_equal, there, minimum.span}};
  return {std::move(result)};
}

}  // namespace patchproof
