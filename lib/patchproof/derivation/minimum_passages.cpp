#include <patchproof/decide/decide.hpp>
#include <patchproof/derivation/claim_derivation.hpp>
#include <patchproof/derivation/shapes.hpp>

namespace patchproof {

namespace {

// The term with one of its nodes, wherever it occurs, replaced by another of the same type.
Term with_node(const Term& term, const Term& node, const Term& image) {
  if (is_one_term(term, node)) return image;
  std::vector<Term> children;
  bool changed = false;
  for (const Term& child : term.children()) {
    children.push_back(with_node(child, node, image));
    changed = changed || children.back().address() != child.address();
  }
  if (!changed) return term;
  return make_term(term.operation(), term.type(), std::move(children), term->payload, term.span());
}

Term difference_of(const Term& a, const Term& b) {
  return make_term(Operation::sum, a.type(), {a, make_term(Operation::negation, b.type(), {b})});
}

// p - r, as a function of the parameters of p.
Term function_difference(const Term& p, const Term& value_of_r, const Term& value_of_p) {
  Formals formals;
  for (std::size_t k = 1; k < value_of_p.children().size(); ++k)
    formals.push_back(value_of_p.child(k).symbol());
  return make_term(Operation::lambda, p.type(), {difference_of(value_of_p, value_of_r)}, formals);
}

}  // namespace

std::vector<Passage> minimum_passages(const MinimumClaim& claim,
                                      const std::vector<KnownValue>& known,
                                      Computation& computation) {
  const MinimumGoal& goal = claim.goal;
  Goal given = goal.goal;
  given.statements.clear();
  given.known = known;
  for (const Statement& constraint : goal.constraints)
    given.assumptions.push_back({"", constraint});
  Passage passage{Passage::Kind::variation, {}, {}, given};
  const Statement& values = goal.goal.statements.front();
  const Term& candidate = values.left;
  const Term& competitor = values.right;
  // competitor == candidate, both at the parameters.
  const Term& p = goal.membership.left;
  const Term& r = goal.membership.right;
  bool of_parameters = p.operation() == Operation::apply;
  for (std::size_t k = 1; of_parameters && k < p.children().size(); ++k)
    of_parameters = p.child(k).operation() == Operation::symbol;
  const Term excess = difference_of(competitor, candidate);
  if (of_parameters) {
    const Term variation = with_node(competitor, p.child(0),
                                     function_difference(p.child(0), r, p));
    // So it is for functionals without linear part; others have no such form.
    Goal guess = given;
    guess.statements = {{excess, Relation::equal, variation, excess.span()}};
    if (decided(guess, computation.limits(), Engines::kernel).verdict == Verdict::proved)
      passage.chains.push_back({excess,
                                {{Relation::equal, variation, {Reason::Kind::integration, {}}},
                                 {Relation::greater_equal, number_term(0), {}}}});
  }
  if (const std::optional<Term> value = computation.collected(candidate);
      value && computation.is_readable(*value) && !computation.same(*value, candidate))
    passage.chains.push_back(
        {candidate, {{Relation::equal, *value, {Reason::Kind::integration, {}}}}});
  return {passage};
}

}  // namespace patchproof
