#include <algorithm>

#include <patchproof/derivation/basis_rows.hpp>
#include <patchproof/derivation/claim_derivation.hpp>

namespace patchproof {

namespace {

// More equations than this are shown as they are, without working them out.
constexpr std::size_t most_worked_out = 6;

const Term& last_of(const Chain& chain) {
  return chain.links.empty() ? chain.start : chain.links.back().term;
}

// The last term of the chain that is a sum in a Bernstein basis.
std::optional<BasisRows> rows_of(const Chain& chain) {
  for (auto link = chain.links.rbegin(); link != chain.links.rend(); ++link)
    if (const auto rows = basis_rows(link->term)) return rows;
  return std::nullopt;
}

Term shortest(const Term& value, const Computation& computation) {
  const std::optional<Term> collected = computation.collected(value);
  return collected && computation.is_readable(*collected) ? *collected : value;
}

// Coefficient by coefficient where both sides are in one basis, else the sides as they are.
void add_conditions(const Chain& left, const Chain& right, const Computation& computation,
                    std::vector<Chain>& conditions) {
  // What is seen to hold, or was said before, is no condition.
  const auto add = [&](const Term& left_side, const Term& right_side) {
    const bool said = std::any_of(conditions.begin(), conditions.end(), [&](const Chain& other) {
      return computation.same(other.start, left_side) &&
             computation.same(other.links.front().term, right_side);
    });
    if (!said && !computation.same(left_side, right_side))
      conditions.push_back({left_side, {{Relation::equal, right_side, {}}}});
  };
  const auto left_rows = rows_of(left);
  const auto right_rows = rows_of(right);
  bool alike = left_rows && right_rows && left_rows->basis.size() == right_rows->basis.size();
  for (std::size_t k = 0; alike && k < left_rows->basis.size(); ++k)
    alike = computation.same(left_rows->basis[k], right_rows->basis[k]);
  if (!alike) {
    add(last_of(left), last_of(right));
    return;
  }
  for (std::size_t k = 0; k < left_rows->basis.size(); ++k)
    add(shortest(left_rows->coefficients[k], computation),
        shortest(right_rows->coefficients[k], computation));
}

}  // namespace

std::vector<Passage> solution_passages(const DeriveClaim& claim, const Decision& decision,
                                       const std::vector<KnownValue>& known,
                                       Computation& computation) {
  Goal given = claim.goal.goal;
  given.statements.clear();
  given.known = known;
  const bool solved =
      decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
  Goal at_solution = given;
  at_solution.known.insert(at_solution.known.end(), decision.solution.begin(),
                           decision.solution.end());
  const std::vector<Statement>& equations = claim.goal.goal.statements;
  const bool few = equations.size() <= most_worked_out;

  Passage sides{Passage::Kind::computation, {}, {}, given};
  Passage conditions{Passage::Kind::condition, {}, {}, at_solution, !solved};
  for (const Statement& equation : equations) {
    Chain left{equation.left, {}};
    Chain right{equation.right, {}};
    if (few) {
      left = computation.of(equation.left);
      right = computation.of(equation.right);
    }
    for (const Chain& side : {left, right})
      if (!side.links.empty()) sides.chains.push_back(side);
    // Equations that are not worked out stand in the statement already.
    if (few) add_conditions(left, right, computation, conditions.chains);
  }
  std::vector<Passage> passages{sides, conditions};
  if (!solved) return passages;

  Passage result{Passage::Kind::result, {}, {}, at_solution};
  for (const Statement& value : claim.gives)
    if (!computation.same(value.left, value.right))
      result.chains.push_back({value.left, {{Relation::equal, value.right, {}}}});
  if (claim.gives.empty())
    for (const KnownValue& value : decision.solution)
      if (computation.is_readable(value.value))
        result.chains.push_back(
            {symbol_term(value.symbol), {{Relation::equal, value.value, {}}}});
  passages.push_back(std::move(result));

  Passage check{Passage::Kind::check, {}, {}, at_solution};
  for (const Statement& equation : equations)
    check.chains.push_back({equation.left, {{Relation::equal, equation.right, {}}}});
  passages.push_back(std::move(check));
  return passages;
}

}  // namespace patchproof
