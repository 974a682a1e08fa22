#include <patchproof/symbolic/second_opinion.hpp>

#include <algorithm>
#include <exception>
#include <functional>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include <patchproof/symbolic/assumptions.hpp>
#include <patchproof/symbolic/elements.hpp>
#include <patchproof/symbolic/evaluation.hpp>
#include <patchproof/symbolic/known_values.hpp>
#include <patchproof/symbolic/linear_rank.hpp>
#include <patchproof/symbolic/normal_form.hpp>
#include <patchproof/symbolic/polynomial_text.hpp>

namespace patchproof {

namespace {

using namespace symbolic;
using GiNaC::ex;
using Answer = SecondOpinion::Answer;

// What cannot be said in budget, or has no value, is no answer.
SecondOpinion answer_of(const std::function<SecondOpinion()>& decide) {
  try {
    return decide();
  } catch (const OverBudget& error) {
    return {Answer::none, std::string{"over budget: "} + error.what(), ""};
  } catch (const std::exception& error) {
    return {Answer::none, error.what(), ""};
  }
}

// The normal forms of left - right under the assumptions, component by component.
GiNaC::exvector differences(Ring& ring, Evaluation& evaluation, Assumptions& assumptions,
                            const Statement& statement) {
  if (statement.relation != Relation::equal) {
    throw std::domain_error{"a relation that is no equation"};
  }
  const Value& left = evaluation(statement.left);
  const Value& right = evaluation(statement.right);
  if (!left.formals.empty() || !right.formals.empty()) {
    throw std::domain_error{"an equation between functions"};
  }
  GiNaC::exvector result;
  for (const ex& difference : sum(ring, {left.components, scaled(ring, right.components, -1)})) {
    result.push_back(normal_form(ring, assumptions(difference)));
  }
  return result;
}

SecondOpinion opinion_on_equations(const Goal& goal, const std::vector<KnownValue>& known,
                                   const Limits& limits) {
  Ring ring{limits};
  Evaluation evaluation{ring, values_of(ring, known)};
  Assumptions assumptions{ring, evaluation, goal.assumptions};
  std::string doubt;
  for (const Statement& statement : goal.statements) {
    for (const ex& difference : differences(ring, evaluation, assumptions, statement)) {
      if (difference.is_zero()) continue;
      if (!assumptions.are_all_used()) {
        doubt = "the difference is not zero, but not all assumptions could be used";
      } else if (!is_surely_not_zero(ring, difference)) {
        doubt = "the difference is not zero in form, but its parts may be related";
      } else {
        return {Answer::fails, "", text(difference, ring.atoms())};
      }
    }
  }
  if (!doubt.empty()) return {Answer::none, doubt, ""};
  return {Answer::holds, "", ""};
}

// The numbers of the atoms that are components of the symbols.
std::set<unsigned> components_of(const Ring& ring, const std::set<unsigned>& ordinals) {
  std::set<unsigned> result;
  for (unsigned id = 0; id < ring.atoms().size(); ++id) {
    const Atom& atom = ring.atoms().at(id);
    if (atom.kind == Atom::Kind::letter && ordinals.contains(atom.symbol->ordinal)) {
      result.insert(id);
    }
  }
  return result;
}

// Linear in the unknowns, with coefficients that have nothing of them in it.
bool is_linear(const Ring& ring, const ex& equation, const std::set<unsigned>& unknowns) {
  for (const Summand& part : summands(equation, ring.atoms())) {
    long degree = 0;
    for (const auto& [id, exponent] : part.powers) {
      const std::set<unsigned>& within = ring.atoms().within(id);
      if (unknowns.contains(id)) {
        if (exponent < 0) return false;
        degree += exponent;
      } else if (std::any_of(within.begin(), within.end(),
                             [&](unsigned inner) { return unknowns.contains(inner); })) {
        return false;
      }
    }
    if (degree > 1) return false;
  }
  return true;
}

bool has_doubtful_roots(const Ring& ring, const ex& equation) {
  const std::set<unsigned> ids = ring.atoms().occurring(equation);
  return std::any_of(ids.begin(), ids.end(), [&](unsigned id) {
    return ring.atoms().at(id).kind == Atom::Kind::root && !ring.atoms().at(id).prime;
  });
}

// One row for each monomial in what depends on the parameters: all their coefficients vanish.
void add_rows(Ring& ring, const ex& equation, const std::set<unsigned>& unknowns,
              LinearRank& rank) {
  if (equation.is_zero()) return;
  if (!is_linear(ring, equation, unknowns)) {
    throw std::domain_error{"an equation that is not linear in the unknowns"};
  }
  if (has_doubtful_roots(ring, equation) || !is_surely_not_zero(ring, equation)) {
    throw std::domain_error{"an equation whose parts may be related"};
  }
  const auto by_parameters = [&](unsigned id) { return has_parameters(ring, id); };
  const auto by_unknowns = [&](unsigned id) { return unknowns.contains(id); };
  for (const auto& [powers, part] : coefficients(equation, ring.atoms(), by_parameters)) {
    LinearRank::Row row;
    for (const auto& [unknown, entry] : coefficients(part, ring.atoms(), by_unknowns)) {
      if (!unknown.empty()) row[unknown.front().first] = entry;
    }
    rank.add(std::move(row));
  }
}

std::set<unsigned> ordinals_of(const std::vector<SymbolPointer>& symbols) {
  std::set<unsigned> result;
  for (const SymbolPointer& symbol : symbols) result.insert(symbol->ordinal);
  return result;
}

std::vector<KnownValue> without(const std::vector<KnownValue>& values,
                                const std::set<unsigned>& ordinals) {
  std::vector<KnownValue> result;
  for (const KnownValue& value : values) {
    if (!ordinals.contains(value.symbol->ordinal)) result.push_back(value);
  }
  return result;
}

// Whether the equations determine all unknowns once the free ones are chosen.
SecondOpinion opinion_on_uniqueness(const SolveGoal& goal, const std::set<unsigned>& free,
                                    const Limits& limits) {
  Ring ring{limits};
  const std::set<unsigned> all = ordinals_of(goal.unknowns);
  Evaluation evaluation{ring, values_of(ring, without(goal.goal.known, all))};
  Assumptions assumptions{ring, evaluation, goal.goal.assumptions, all};
  std::vector<ex> equations;
  for (const Statement& statement : goal.goal.statements) {
    const GiNaC::exvector parts = differences(ring, evaluation, assumptions, statement);
    equations.insert(equations.end(), parts.begin(), parts.end());
  }
  std::set<unsigned> wanted = all;
  for (const unsigned ordinal : free) wanted.erase(ordinal);
  const std::set<unsigned> unknowns = components_of(ring, wanted);
  LinearRank rank{ring};
  for (const ex& equation : equations) add_rows(ring, equation, unknowns, rank);
  for (const SymbolPointer& symbol : goal.unknowns) {
    if (!wanted.contains(symbol->ordinal)) continue;
    for (std::size_t i = 0; i < symbol->type.component_count(); ++i) {
      const unsigned id = ring.atoms().id_of(letter(ring, symbol, static_cast<int>(i)));
      if (rank.is_pivot(id)) continue;
      if (!assumptions.are_all_used()) {
        return {Answer::none, "not all assumptions could be used", ""};
      }
      return {Answer::fails,
              "the solution is not unique: another value of " + symbol->name + " is possible", ""};
    }
  }
  return {Answer::holds, "", ""};
}

}  // namespace

SecondOpinion second_opinion(const Goal& goal, const Limits& limits) {
  return answer_of([&] { return opinion_on_equations(goal, goal.known, limits); });
}

SecondOpinion second_opinion_on_solution(const SolveGoal& goal,
                                         const std::vector<KnownValue>& solution,
                                         const std::vector<SymbolPointer>& free,
                                         const Limits& limits) {
  return answer_of([&]() -> SecondOpinion {
    const std::set<unsigned> free_ordinals = ordinals_of(free);
    std::vector<KnownValue> known = without(solution, free_ordinals);
    const std::vector<KnownValue> others = without(goal.goal.known, ordinals_of(goal.unknowns));
    known.insert(known.end(), others.begin(), others.end());
    const SecondOpinion holds = opinion_on_equations(goal.goal, known, limits);
    if (holds.answer != Answer::holds) return holds;
    return opinion_on_uniqueness(goal, free_ordinals, limits);
  });
}

}  // namespace patchproof
