#include <algorithm>
#include <functional>

#include <patchproof/language/case_elaborator.hpp>
#include <patchproof/language/nearest_name.hpp>
#include <patchproof/term/plain_text.hpp>

namespace patchproof {

namespace {

Relation relation_of(const std::string& symbol) {
  if (symbol == "==") return Relation::equal;
  if (symbol == "!=") return Relation::not_equal;
  if (symbol == "<") return Relation::less;
  if (symbol == "<=") return Relation::less_equal;
  return symbol == ">" ? Relation::greater : Relation::greater_equal;
}

}  // namespace

void CaseElaborator::add_relation(Term left, Relation relation, Term right, const Span& span,
                                  const Scope& scope, Goal& goal) {
  const std::size_t ranges = goal.ranges.size();
  std::tie(left, right) = elaborator_.construct().same_type(scope, left, right, span, goal.ranges);
  const bool order = relation != Relation::equal && relation != Relation::not_equal;
  if (order && goal.ranges.size() > ranges)
    throw Fault{span, "the range of '" + goal.ranges.back().parameter->name + "' is not declared",
                "param " + goal.ranges.back().parameter->name + " in [0, 1]"};
  if (order && !left.type().is_scalar())
    throw Fault{span, "only scalars are smaller or larger, not a " + to_text(left.type())};
  goal.statements.push_back({left, relation, right, span});
}

// p == r on boundary: on all four edges of the rectangle of the parameters.
void CaseElaborator::add_boundary_relation(const Term& left, const Term& right, const Span& span,
                                           const Scope& scope, Goal& goal) {
  const Term& function = left.type().is_function() ? left : right;
  if (!function.type().is_function() || function.type().parameters.size() != 2)
    throw Fault{span, "'on boundary' compares two patches"};
  Construction& construct = elaborator_.construct();
  Goal whole;
  whole.ranges = goal.ranges;
  add_relation(left, Relation::equal, right, span, scope, whole);
  const Statement& inside = whole.statements.front();
  goal.ranges = whole.ranges;
  Formals formals;
  for (const std::string& name : function.type().parameters) {
    const auto range = std::find_if(goal.ranges.rbegin(), goal.ranges.rend(), [&](const auto& r) {
      return r.parameter->name == name;
    });
    if (range == goal.ranges.rend()) throw Fault{span, "'" + name + "' has no range"};
    formals.push_back(range->parameter);
  }
  const Term left_patch = construct.lambda(formals, inside.left, span);
  const Term right_patch = construct.lambda(formals, inside.right, span);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto range = std::find_if(goal.ranges.begin(), goal.ranges.end(), [&](const auto& r) {
      return r.parameter->ordinal == formals[k]->ordinal;
    });
    const ParameterRange ends = *range;
    for (const Term& end : {ends.lower, ends.upper}) {
      std::vector<Term> at{symbol_term(formals[0], span), symbol_term(formals[1], span)};
      at[k] = end;
      goal.statements.push_back({construct.apply(left_patch, at, span), Relation::equal,
                                 construct.apply(right_patch, at, span), span});
    }
  }
}

void CaseElaborator::add_comparison(const syntax::Comparison& comparison, const Scope& scope,
                                    Goal& goal) {
  std::vector<Term> operands;
  for (const auto& operand : comparison.operands)
    operands.push_back(elaborator_.expression(*operand, scope));
  for (std::size_t k = 0; k + 1 < operands.size(); ++k) {
    const Relation relation = relation_of(comparison.operators[k]);
    if (!comparison.on_boundary) {
      add_relation(operands[k], relation, operands[k + 1], comparison.span, scope, goal);
    } else if (relation == Relation::equal) {
      add_boundary_relation(operands[k], operands[k + 1], comparison.span, scope, goal);
    } else {
      throw Fault{comparison.span, "'on boundary' goes with '=='"};
    }
  }
}

Goal CaseElaborator::goal_of(const syntax::Proposition& proposition, const Scope& scope) {
  Goal goal;
  goal.ranges = ranges_;
  goal.assumptions = assumptions_;
  for (const syntax::Comparison& comparison : proposition.comparisons)
    add_comparison(comparison, scope, goal);
  if (proposition.joint) add_joint(*proposition.joint, scope, goal);
  for (const syntax::Joint& joint : proposition.further_joints) add_joint(joint, scope, goal);
  return goal;
}

void CaseElaborator::check_uses(const syntax::Statement& statement, Claim& claim) {
  for (const syntax::Name& name : statement.clauses.using_labels) {
    if (!derivations_.contains(name.text)) {
      const std::vector<std::string> known{derivations_.begin(), derivations_.end()};
      throw Fault{name.span, "'using' needs a derivation above, and '" + name.text + "' is none",
                  did_you_mean(name.text, known)};
    }
    claim.uses.push_back(name.text);
  }
}

void CaseElaborator::identity(const syntax::Statement& statement,
                              const syntax::Proposition& proposition, const std::string& label,
                              const std::string& verb, const Scope& scope,
                              const std::string& instance, Case& result) {
  Claim claim;
  claim.label = label;
  claim.instance = instance;
  claim.verb = verb;
  claim.expectation = verb == "refute" || verb == "printed" ? Expectation::refute
                      : verb == "open"                      ? Expectation::open
                                                            : Expectation::prove;
  claim.span = statement.span;
  claim.statement = proposition.span;
  claim.note = statement.note.value_or("");
  check_uses(statement, claim);
  if (proposition.minimum)
    claim.kind = minimum(*proposition.minimum, scope);
  else
    claim.kind = IdentityClaim{goal_of(proposition, scope)};
  result.claims.push_back(std::move(claim));
}

std::vector<SymbolPointer> CaseElaborator::unknowns_of(const Term& term, const Span& span) const {
  std::vector<SymbolPointer> all;
  std::vector<SymbolPointer> holes;
  const auto add = [&](const Term& t) {
    if (t.operation() != Operation::symbol) return;
    const SymbolPointer& symbol = t.symbol();
    if (symbol->role != Symbol::Role::point && symbol->role != Symbol::Role::scalar) return;
    all.push_back(symbol);
    if (holes_.contains(symbol->ordinal)) holes.push_back(symbol);
  };
  add(term);
  if (term.operation() == Operation::matrix)
    for (const Term& entry : term.children()) add(entry);
  const std::vector<SymbolPointer>& result = holes.empty() ? all : holes;
  if (result.empty())
    throw Fault{span, "nothing here is unknown: derive needs points, scalars, or a matrix with '?'"};
  return result;
}

void CaseElaborator::derive(const syntax::Statement& statement, const Scope& scope,
                            const std::string& instance, Case& result) {
  Claim claim;
  claim.label = statement.label->text;
  claim.instance = instance;
  claim.verb = "derive";
  claim.expectation = statement.inconsistent ? Expectation::inconsistent : Expectation::prove;
  claim.span = statement.span;
  claim.statement = statement.proposition.span;
  check_uses(statement, claim);
  DeriveClaim derive;
  std::vector<Term> unknown_terms;
  for (const auto& e : statement.unknowns) {
    unknown_terms.push_back(elaborator_.expression(*e, scope));
    for (const SymbolPointer& symbol : unknowns_of(unknown_terms.back(), e->span)) {
      const bool known =
          std::any_of(derive.goal.unknowns.begin(), derive.goal.unknowns.end(),
                      [&](const SymbolPointer& u) { return u->ordinal == symbol->ordinal; });
      if (!known) derive.goal.unknowns.push_back(symbol);
    }
  }
  derive.goal.goal = goal_of(statement.proposition, scope);
  for (const Statement& s : derive.goal.goal.statements)
    if (s.relation != Relation::equal)
      throw Fault{s.span, "unknowns are derived from equations, written '=='"};
  if (!statement.gives.empty() && statement.gives.size() != unknown_terms.size())
    throw Fault{statement.gives.front()->span,
                "as many values as unknowns are needed: " + std::to_string(unknown_terms.size()) +
                    ", not " + std::to_string(statement.gives.size())};
  Goal gives;
  for (std::size_t k = 0; k < statement.gives.size(); ++k) {
    const syntax::Expression& e = *statement.gives[k];
    add_relation(unknown_terms[k], Relation::equal, elaborator_.expression(e, scope), e.span, scope,
                 gives);
  }
  derive.gives = std::move(gives.statements);
  derive.goal.goal.ranges.insert(derive.goal.goal.ranges.end(), gives.ranges.begin(),
                                 gives.ranges.end());
  for (const auto& e : statement.leaves)
    for (const SymbolPointer& symbol : unknowns_of(elaborator_.expression(*e, scope), e->span)) {
      const bool known =
          std::any_of(derive.goal.unknowns.begin(), derive.goal.unknowns.end(),
                      [&](const SymbolPointer& u) { return u->ordinal == symbol->ordinal; });
      if (!known) throw Fault{e->span, "'" + symbol->name + "' is not one of the unknowns"};
      derive.leaves.push_back(symbol);
    }
  claim.kind = std::move(derive);
  result.claims.push_back(std::move(claim));
}

void CaseElaborator::claim(const syntax::Statement& statement, Case& result) {
  using Kind = syntax::Statement::Kind;
  const auto& binders = statement.clauses.binders;
  const std::size_t before = result.claims.size();
  try {
    for (const std::vector<int>& values : elaborator_.combinations(binders, scope_, most_instances)) {
      std::string instance;
      for (std::size_t k = 0; k < binders.size(); ++k)
        instance += (instance.empty() ? "" : ",") + binders[k].name.text + "=" +
                    std::to_string(values[k]);
      if (!instance_.empty()) instance = instance_ + (instance.empty() ? "" : "," + instance);
      if (!instance.empty()) instance = "[" + instance + "]";
      const Scope scope = Elaborator::bound(scope_, binders, values);
      const std::string label = statement.label->text;
      switch (statement.kind) {
        case Kind::derive: derive(statement, scope, instance, result); break;
        case Kind::erratum:
          identity(statement, statement.printed, label + ".printed", "printed", scope, instance,
                   result);
          identity(statement, statement.corrected, label + ".corrected", "corrected", scope,
                   instance, result);
          break;
        default:
          identity(statement, statement.proposition, label,
                   statement.kind == Kind::prove    ? "prove"
                   : statement.kind == Kind::refute ? "refute"
                                                    : "open",
                   scope, instance, result);
          break;
      }
    }
  } catch (const Fault&) {
    // A claim is read as a whole or not at all.
    result.claims.erase(result.claims.begin() + static_cast<std::ptrdiff_t>(before),
                        result.claims.end());
    throw;
  }
  if (statement.kind == Kind::derive) derivations_.insert(statement.label->text);
}

}  // namespace patchproof
