#include <patchproof/derivation/claim_derivation.hpp>

#include <patchproof/derivation/shapes.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

Goal without_statements(const Goal& goal, const std::vector<KnownValue>& known) {
  Goal given = goal;
  given.statements.clear();
  given.known = known;
  return given;
}

bool holds(const Decision& decision) {
  return decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
}

const Term& last_of(const Chain& chain) {
  return chain.links.empty() ? chain.start : chain.links.back().term;
}

Relation denied(Relation relation) {
  switch (relation) {
    case Relation::equal: return Relation::not_equal;
    case Relation::not_equal: return Relation::equal;
    case Relation::less: return Relation::greater_equal;
    case Relation::less_equal: return Relation::greater;
    case Relation::greater: return Relation::less_equal;
    default: return Relation::less;
  }
}

// The statement with the unknown functions of the witness put in. Whatever has a name in the case
// keeps it: r is still r when its boundary curves are given.
Statement with_functions(const Statement& statement, const std::vector<KnownValue>& functions,
                         Computation& computation) {
  if (functions.empty()) return statement;
  std::map<unsigned, Term> images;
  for (const KnownValue& function : functions)
    images.emplace(function.symbol->ordinal, function.value);
  // All at once, so that what is shared stays shared.
  std::vector<Term> parts{statement.left, statement.right};
  const std::vector<NamedTerm> named = computation.named_terms();
  for (const NamedTerm& item : named) parts.push_back(item.term);
  const Term all =
      replaced(make_term(Operation::tuple, Type::scalar(), std::move(parts)), images);
  for (std::size_t k = 0; k < named.size(); ++k)
    computation.add_name(all.child(k + 2), named[k].name);
  for (const KnownValue& function : functions)
    computation.add_name(function.value, function.symbol->name);
  return {all.child(0), statement.relation, all.child(1), statement.span};
}

// Both sides of the false statement at the witness: left = number, not equal to number = right.
Passage witness_passage(const Goal& goal, const Decision& decision,
                        const std::vector<KnownValue>& known, Computation& computation) {
  Passage passage{Passage::Kind::witness, {}, decision.witness.assignment, {}};
  passage.given.known = known;
  std::map<unsigned, Term> places;
  std::vector<KnownValue> functions;
  for (const KnownValue& value : passage.values) {
    if (value.symbol->role == Symbol::Role::parameter)
      places.emplace(value.symbol->ordinal, value.value);
    else if (value.symbol->role == Symbol::Role::function)
      functions.push_back(value);
    else
      passage.given.known.push_back(value);
  }
  // What was derived has a value there too.
  for (const KnownValue& derived : known) {
    const auto value =
        computation.collected(replaced(derived.value, places), passage.given.known);
    if (value && free_symbols(*value).empty()) passage.values.push_back({derived.symbol, *value});
  }
  const Statement numeric =
      with_functions(goal.statements.at(decision.statement), functions, computation);
  const Term left = replaced(numeric.left, places);
  const Term right = replaced(numeric.right, places);
  const std::optional<Term> left_value = computation.collected(left, passage.given.known);
  const std::optional<Term> right_value = computation.collected(right, passage.given.known);
  // What follows from assumptions has no value of its own.
  if (!left_value || !right_value || !free_symbols(*left_value).empty() ||
      !free_symbols(*right_value).empty())
    return passage;
  const Reason put_in{Reason::Kind::value, {}};
  Chain chain{left, {}};
  const auto append = [&](Relation relation, const Term& term, const Reason& reason) {
    if (relation == Relation::equal && computation.same(last_of(chain), term)) return;
    chain.links.push_back({relation, term, reason});
  };
  append(Relation::equal, *left_value, put_in);
  append(denied(numeric.relation), *right_value, {});
  append(Relation::equal, right, put_in);
  passage.chains.push_back(std::move(chain));
  return passage;
}

// left - right, as it is for all values.
Passage difference_passage(const Goal& goal, const Decision& decision,
                           const std::vector<KnownValue>& known, Computation& computation) {
  Passage passage{Passage::Kind::difference, {}, {}, without_statements(goal, known)};
  const Statement& statement = goal.statements.at(decision.statement);
  if (statement.relation != Relation::equal || is_zero_term(statement.right)) return passage;
  const Type& type = statement.left.type();
  const Term difference = make_term(
      Operation::sum, type,
      {statement.left, make_term(Operation::negation, type, {statement.right})});
  const std::optional<Term> value = computation.collected(difference, known);
  if (!value || !computation.is_readable(*value) || computation.same(difference, *value))
    return passage;
  passage.chains.push_back(
      {difference, {{Relation::equal, *value, {Reason::Kind::collected, {}}}}});
  return passage;
}

Statement turned_round(const Statement& statement) {
  const auto turned = [](Relation relation) {
    switch (relation) {
      case Relation::less: return Relation::greater;
      case Relation::less_equal: return Relation::greater_equal;
      case Relation::greater: return Relation::less;
      case Relation::greater_equal: return Relation::less_equal;
      default: return relation;
    }
  };
  return {statement.right, turned(statement.relation), statement.left, statement.span};
}

// Both sides worked out until they meet.
std::vector<Chain> meeting_chains(const Statement& statement, const Reason& reason,
                                  Computation& computation) {
  // 0 <= f is read as f = … >= 0.
  if (statement.left.is_number() && statement.relation != Relation::equal &&
      !statement.right.is_number())
    return meeting_chains(turned_round(statement), reason, computation);
  Chain left = computation.of(statement.left);
  if (statement.relation != Relation::equal) {
    left.links.push_back({statement.relation, statement.right, {}});
    return {left};
  }
  // A link that already is the right side ends the chain.
  for (std::size_t k = 0; k < left.links.size(); ++k) {
    if (!computation.same(left.links[k].term, statement.right)) continue;
    left.links.resize(k + 1);
    return {left};
  }
  if (computation.is_plain(statement.right) || is_zero_term(statement.right)) {
    left.links.push_back({Relation::equal, statement.right, reason});
    return {left};
  }
  Chain right = computation.of(statement.right);
  for (std::size_t k = 0; k < left.links.size(); ++k) {
    for (std::size_t m = 0; m < right.links.size(); ++m) {
      if (!computation.same(left.links[k].term, right.links[m].term)) continue;
      left.links.resize(k + 1);
      right.links.resize(m + 1);
      return {left, right};
    }
  }
  const Term& meeting = last_of(left);
  if (!computation.same(last_of(right), meeting))
    right.links.push_back({Relation::equal, meeting, reason});
  if (left.links.empty()) return {right};
  return right.links.empty() ? std::vector<Chain>{left} : std::vector<Chain>{left, right};
}

std::vector<Passage> identity_passages(const IdentityClaim& claim, const Decision& decision,
                                       const std::vector<KnownValue>& known,
                                       const std::vector<std::string>& uses,
                                       Computation& computation) {
  std::vector<Passage> passages;
  if (decision.verdict == Verdict::refuted) {
    passages.push_back(difference_passage(claim.goal, decision, known, computation));
    passages.push_back(witness_passage(claim.goal, decision, known, computation));
    return passages;
  }
  if (!holds(decision)) return passages;
  Passage passage{Passage::Kind::computation, {}, {}, without_statements(claim.goal, known)};
  // Where nothing else is used, the last link is a calculation.
  Reason reason{Reason::Kind::collected, {}};
  if (!decision.assumptions_used.empty())
    reason = {Reason::Kind::assumption, decision.assumptions_used};
  else if (!uses.empty())
    reason = {Reason::Kind::derived, uses};
  for (const Statement& statement : claim.goal.statements)
    for (Chain& chain : equation_chains(statement, reason, computation))
      passage.chains.push_back(std::move(chain));
  passages.push_back(std::move(passage));
  return passages;
}

std::vector<Passage> minimum_derivation(const MinimumClaim& claim, const Decision& decision,
                                        const std::vector<KnownValue>& known,
                                        Computation& computation) {
  if (holds(decision)) return minimum_passages(claim, known, computation);
  if (decision.verdict != Verdict::refuted) return {};
  return {witness_passage(claim.goal.goal, decision, known, computation)};
}

}  // namespace

std::vector<Chain> equation_chains(const Statement& statement, const Reason& reason,
                                   Computation& computation) {
  std::vector<Chain> chains = computation.lower_derivatives(statement.left);
  for (Chain& chain : meeting_chains(statement, reason, computation))
    chains.push_back(std::move(chain));
  return chains;
}

Derivation claim_derivation(const ClaimResult& result, const std::vector<KnownValue>& known,
                            Computation& computation) {
  const Decision& decision = result.decision;
  Derivation derivation{std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        if constexpr (std::is_same_v<Kind, IdentityClaim>)
          return identity_passages(kind, decision, known, result.claim.uses, computation);
        else if constexpr (std::is_same_v<Kind, DeriveClaim>)
          return solution_passages(kind, decision, known, computation);
        else
          return minimum_derivation(kind, decision, known, computation);
      },
      result.claim.kind)};
  if (holds(decision))
    for (Passage& passage : derivation.passages) passage.conditions = decision.conditions;
  return derivation;
}

}  // namespace patchproof
