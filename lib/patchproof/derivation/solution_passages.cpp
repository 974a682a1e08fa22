#include <patchproof/derivation/claim_derivation.hpp>

namespace patchproof {

namespace {

// More equations than this are shown as they are, without working them out.
constexpr std::size_t most_worked_out = 6;

const Term& last_of(const Chain& chain) {
  return chain.links.empty() ? chain.start : chain.links.back().term;
}

}  // namespace

std::vector<Passage> solution_passages(const DeriveClaim& claim, const Decision& decision,
                                       const std::vector<KnownValue>& known,
                                       Computation& computation) {
  Goal given = claim.goal.goal;
  given.statements.clear();
  given.known = known;
  const std::vector<Statement>& equations = claim.goal.goal.statements;
  const bool few = equations.size() <= most_worked_out;

  Passage sides{Passage::Kind::computation, {}, {}, given};
  Passage conditions{Passage::Kind::condition, {}, {}, given};
  for (const Statement& equation : equations) {
    Chain left{equation.left, {}};
    Chain right{equation.right, {}};
    if (few) {
      left = computation.of(equation.left);
      right = computation.of(equation.right);
    }
    for (const Chain& side : {left, right})
      if (!side.links.empty()) sides.chains.push_back(side);
    conditions.chains.push_back({last_of(left), {{Relation::equal, last_of(right), {}}}});
  }
  std::vector<Passage> passages{sides, conditions};
  if (decision.verdict != Verdict::proved && decision.verdict != Verdict::proved_if)
    return passages;

  given.known.insert(given.known.end(), decision.solution.begin(), decision.solution.end());
  Passage result{Passage::Kind::result, {}, {}, given};
  for (const Statement& value : claim.gives)
    result.chains.push_back({value.left, {{Relation::equal, value.right, {}}}});
  if (claim.gives.empty())
    for (const KnownValue& value : decision.solution)
      if (computation.is_readable(value.value))
        result.chains.push_back(
            {symbol_term(value.symbol), {{Relation::equal, value.value, {}}}});
  passages.push_back(std::move(result));

  Passage check{Passage::Kind::check, {}, {}, given};
  for (const Statement& equation : equations)
    check.chains.push_back({equation.left, {{Relation::equal, equation.right, {}}}});
  passages.push_back(std::move(check));
  return passages;
}

}  // namespace patchproof
