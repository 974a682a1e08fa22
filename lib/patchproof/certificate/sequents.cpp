#include <patchproof/certificate/sequents.hpp>

#include <algorithm>

#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

// Puts the values of derivations into terms, also where a value needs another one.
class KnownValues {
 public:
  explicit KnownValues(const std::vector<KnownValue>& known) {
    for (const KnownValue& value : known) images_.emplace(value.symbol->ordinal, value.value);
  }

  Term in(Term term) const {
    // Each round puts in at least one value for good: the kernel has refused values in a circle.
    for (std::size_t round = 0; round <= images_.size(); ++round) {
      const Term next = replaced(term, images_);
      if (next.address() == term.address()) break;
      term = next;
    }
    return term;
  }

  Statement in(const Statement& statement) const {
    return {in(statement.left), statement.relation, in(statement.right), statement.span};
  }

 private:
  std::map<unsigned, Term> images_;
};

struct Given {
  std::vector<Assumption> assumptions;
  std::vector<Statement> equations;
};

void add_ranges(const std::vector<ParameterRange>& ranges, Sequent& sequent) {
  std::map<unsigned, SymbolPointer> named;
  const auto note = [&](const Statement& statement) {
    named.merge(free_symbols(statement.left));
    named.merge(free_symbols(statement.right));
  };
  for (const Assumption& hypothesis : sequent.hypotheses) note(hypothesis.statement);
  for (const Statement& conclusion : sequent.conclusions) note(conclusion);
  // The ends of a range may speak of other parameters, whose ranges come before.
  for (auto range = ranges.rbegin(); range != ranges.rend(); ++range) {
    if (!named.contains(range->parameter->ordinal)) continue;
    named.merge(free_symbols(range->lower));
    named.merge(free_symbols(range->upper));
  }
  for (const ParameterRange& range : ranges)
    if (named.contains(range.parameter->ordinal)) sequent.ranges.push_back(range);
}

Sequent sequent(const std::vector<Assumption>& assumptions, const std::vector<Statement>& equations,
                const std::vector<Statement>& conclusions, const std::vector<ParameterRange>& ranges,
                const KnownValues& known) {
  Sequent result;
  for (const Assumption& assumption : assumptions)
    result.hypotheses.push_back({assumption.label, known.in(assumption.statement)});
  for (const Statement& equation : equations) result.hypotheses.push_back({"", known.in(equation)});
  for (const Statement& conclusion : conclusions) result.conclusions.push_back(known.in(conclusion));
  add_ranges(ranges, result);
  return result;
}

std::vector<Assumption> assumptions_of(const Goal& goal, const ClaimResult& claim) {
  std::vector<Assumption> result = goal.assumptions;
  result.insert(result.end(), claim.agreements.begin(), claim.agreements.end());
  return result;
}

std::vector<Sequent> of(const IdentityClaim& kind, const ClaimResult& claim) {
  return {sequent(assumptions_of(kind.goal, claim), {}, kind.goal.statements, kind.goal.ranges,
                  KnownValues{claim.known})};
}

std::vector<Sequent> of(const MinimumClaim& kind, const ClaimResult& claim) {
  return {sequent(assumptions_of(kind.goal.goal, claim), kind.goal.constraints,
                  kind.goal.goal.statements, kind.goal.goal.ranges, KnownValues{claim.known})};
}

std::vector<Sequent> of(const DeriveClaim& kind, const ClaimResult& claim) {
  const Goal& goal = kind.goal.goal;
  const KnownValues known{claim.known};
  std::vector<Statement> values;
  for (const KnownValue& value : claim.decision.solution)
    values.push_back({symbol_term(value.symbol), Relation::equal, value.value, claim.claim.span});
  std::vector<Statement> conclusions = values;
  conclusions.insert(conclusions.end(), kind.gives.begin(), kind.gives.end());
  const std::vector<Assumption> assumptions = assumptions_of(goal, claim);
  // What is assumed of an unknown is one more equation, and what is said of it is not assumed.
  std::vector<Assumption> others;
  std::vector<Statement> equations = goal.statements;
  for (const Assumption& assumption : assumptions) {
    std::map<unsigned, SymbolPointer> symbols = free_symbols(assumption.statement.left);
    symbols.merge(free_symbols(assumption.statement.right));
    const bool about_unknowns =
        std::any_of(kind.goal.unknowns.begin(), kind.goal.unknowns.end(),
                    [&](const SymbolPointer& u) { return symbols.contains(u->ordinal); });
    if (about_unknowns && assumption.statement.relation == Relation::equal)
      equations.push_back(assumption.statement);
    else
      others.push_back(assumption);
  }
  return {sequent(others, equations, conclusions, goal.ranges, known),
          sequent(others, values, equations, goal.ranges, known)};
}

}  // namespace

std::vector<Sequent> sequents_of(const ClaimResult& claim) {
  return std::visit([&](const auto& kind) { return of(kind, claim); }, claim.claim.kind);
}

std::vector<SymbolPointer> parameters_of(const Statement& statement) {
  std::map<unsigned, SymbolPointer> symbols = free_symbols(statement.left);
  symbols.merge(free_symbols(statement.right));
  std::vector<SymbolPointer> result;
  for (const auto& [ordinal, symbol] : symbols)
    if (symbol->role == Symbol::Role::parameter) result.push_back(symbol);
  return result;
}

std::size_t component_count(const Statement& statement) {
  return statement.left.type().component_count();
}

std::vector<Fact> facts_of(const Sequent& sequent) {
  std::vector<Fact> result;
  const auto difference = [](const Term& a, const Term& b) {
    return make_term(Operation::sum, Type::scalar(),
                     {a, make_term(Operation::negation, Type::scalar(), {b})});
  };
  for (const ParameterRange& range : sequent.ranges) {
    const Term parameter = symbol_term(range.parameter);
    result.push_back({difference(parameter, range.lower), false});
    result.push_back({difference(range.upper, parameter), false});
  }
  for (const Assumption& hypothesis : sequent.hypotheses) {
    const Statement& s = hypothesis.statement;
    switch (s.relation) {
      case Relation::less: result.push_back({difference(s.right, s.left), true}); break;
      case Relation::less_equal: result.push_back({difference(s.right, s.left), false}); break;
      case Relation::greater: result.push_back({difference(s.left, s.right), true}); break;
      case Relation::greater_equal: result.push_back({difference(s.left, s.right), false}); break;
      default: break;
    }
  }
  return result;
}

}  // namespace patchproof
