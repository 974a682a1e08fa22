#include <algorithm>

#include <patchproof/decide/decide.hpp>
#include <patchproof/decide/guard.hpp>
#include <patchproof/kernel/identity.hpp>
#include <patchproof/kernel/polynomial_term.hpp>
#include <patchproof/kernel/readable.hpp>
#include <patchproof/kernel/unknowns.hpp>
#include <patchproof/symbolic/second_opinion.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

class Solver {
 public:
  Solver(const SolveGoal& goal, const std::vector<Statement>& gives,
         const std::vector<SymbolPointer>& leaves, Workspace& workspace)
      : goal_{with_assumptions_as_equations(goal)},
        gives_{gives},
        leaves_{leaves},
        workspace_{workspace},
        evaluator_{workspace, goal_.goal.known},
        hypotheses_{goal_.goal, std::vector<bool>(goal_.goal.assumptions.size(), true), evaluator_,
                    workspace} {}

  Decision run() {
    Decision result;
    if (hypotheses_.contradictory()) {
      result.verdict = Verdict::vacuous;
      result.reason = "the assumptions contradict each other";
      return result;
    }
    if (!hypotheses_.left_out().empty()) {
      result.reason = hypotheses_.left_out().front();
      return result;
    }
    order_unknowns();
    require_values_without_unknowns();
    const UnknownSystem system =
        solved_system(goal_.goal.statements, variables_, evaluator_, hypotheses_, workspace_);
    result.evidence = Evidence::kernel;
    if (!system.solution.contradictions.empty()) {
      return contradiction(system.solution.contradictions);
    }
    Conditions conditions = system.conditions;
    for (const Polynomial& pivot : system.solution.pivots) {
      const Conditions one{{Condition::Kind::not_zero, pivot}};
      keep_open(one, hypotheses_, workspace_, {}, conditions);
    }
    result.conditions = in_words(conditions, workspace_);
    describe(system, result);
    const bool as_said = result.free == names_of_leaves();
    result.verdict = !as_said                ? Verdict::underdetermined
                     : conditions.empty() ? Verdict::proved
                                          : Verdict::proved_if;
    return result;
  }

  const SolveGoal& goal() const { return goal_; }

 private:
  // No solution at all, or none except where the given data are special.
  Decision contradiction(const std::vector<Fraction>& left_over) {
    Decision result;
    for (const Fraction& fraction : left_over) {
      const std::string text = to_text(fraction, workspace_.atoms, workspace_.budget, 300);
      if (!hypotheses_.facts().never_zero(fraction.numerator(), workspace_.budget)) {
        if (result.reason.empty()) result.reason = "there is a solution only where " + text + " == 0";
        continue;
      }
      result.verdict = Verdict::inconsistent;
      result.evidence = Evidence::kernel;
      result.reason = "the equations lead to 0 == " + text;
      return result;
    }
    return result;
  }

  // An assumption about an unknown is one more equation for it.
  static SolveGoal with_assumptions_as_equations(const SolveGoal& goal) {
    SolveGoal result = goal;
    result.goal.assumptions.clear();
    for (const Assumption& assumption : goal.goal.assumptions) {
      std::map<unsigned, SymbolPointer> symbols = free_symbols(assumption.statement.left);
      symbols.merge(free_symbols(assumption.statement.right));
      const bool about_unknowns =
          std::any_of(goal.unknowns.begin(), goal.unknowns.end(), [&](const SymbolPointer& u) {
            return symbols.contains(u->ordinal);
          });
      if (about_unknowns && assumption.statement.relation == Relation::equal)
        result.goal.statements.push_back(assumption.statement);
      else
        result.goal.assumptions.push_back(assumption);
    }
    return result;
  }

  // "derive x … gives x" would be true of everything. A value may mention an unknown whose terms
  // cancel, as P_u(0,0) of a net does.
  void require_values_without_unknowns() {
    for (const Statement& given : gives_) {
      for (const Fraction& component : evaluator_.value(given.right).components) {
        const std::set<Variable> within = variables(component);
        for (std::size_t k = 0; k < variables_.size(); ++k)
          if (within.contains(variables_[k]) && !is_left(symbols_[k]))
            throw OutsideTheory{"the value given contains the unknown '" + symbols_[k]->name +
                                "', so there is nothing to compare"};
      }
    }
  }

  bool is_left(const SymbolPointer& symbol) const {
    return std::any_of(leaves_.begin(), leaves_.end(), [&](const SymbolPointer& leaf) {
      return leaf->ordinal == symbol->ordinal;
    });
  }

  // Unknowns that may stay free come last: elimination then leaves them free.
  void order_unknowns() {
    for (const bool left : {false, true}) {
      for (const SymbolPointer& symbol : goal_.unknowns) {
        if (is_left(symbol) != left) continue;
        for (std::size_t k = 0; k < symbol->type.component_count(); ++k) {
          variables_.push_back(workspace_.atoms.symbol(symbol, static_cast<int>(k)));
          symbols_.push_back(symbol);
        }
      }
    }
  }

  std::vector<std::string> names_of_leaves() const {
    std::vector<std::string> names;
    for (const SymbolPointer& symbol : goal_.unknowns)
      if (is_left(symbol)) names.push_back(symbol->name);
    return names;
  }

  void describe(const UnknownSystem& system, Decision& result) {
    for (const SymbolPointer& symbol : goal_.unknowns) {
      std::vector<Fraction> components;
      std::vector<std::string> free;
      for (std::size_t k = 0; k < variables_.size(); ++k) {
        if (symbols_[k]->ordinal != symbol->ordinal) continue;
        const auto& is_free = system.solution.free;
        if (std::find(is_free.begin(), is_free.end(), k) != is_free.end())
          free.push_back(symbol->name + component_name(symbol->type, components.size()));
        components.push_back(component(system, k));
      }
      if (free.size() == components.size()) free = {symbol->name};
      result.free.insert(result.free.end(), free.begin(), free.end());
      if (!free.empty()) continue;
      result.derived.emplace_back(symbol->name, in_words(components));
      if (const auto value = value_term(components, symbol->type, workspace_.atoms))
        result.solution.push_back({symbol, *value});
    }
  }

  Fraction component(const UnknownSystem& system, std::size_t k) {
    Fraction total = system.solution.constant_part[k];
    for (std::size_t f = 0; f < system.solution.free.size(); ++f)
      total = sum(total,
                  product(system.solution.factors[k][f],
                          Polynomial::variable(variables_[system.solution.free[f]]),
                          workspace_.budget),
                  workspace_.budget);
    return normal_form(total, workspace_);
  }

  std::string in_words(const std::vector<Fraction>& components) {
    std::string text;
    for (const Fraction& c : components)
      text += (text.empty() ? "" : ", ") + to_text(c, workspace_.atoms, workspace_.budget, 600);
    return components.size() == 1 ? text : "(" + text + ")";
  }
  static std::vector<std::string> in_words(const Conditions& conditions, Workspace& workspace) {
    return patchproof::in_words(conditions, workspace);
  }

  SolveGoal goal_;
  const std::vector<Statement>& gives_;
  const std::vector<SymbolPointer>& leaves_;
  Workspace& workspace_;
  Evaluator evaluator_;
  Hypotheses hypotheses_;
  std::vector<Variable> variables_;
  std::vector<SymbolPointer> symbols_;
};

bool is_solved(const Decision& decision) {
  return decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
}

// Whether what the solution is said to be is what it is; also shows the assumptions consistent.
Decision compared(Decision solution, const SolveGoal& goal, const std::vector<Statement>& gives,
                  const Limits& limits, Engines engines) {
  Goal claim = goal.goal;
  claim.statements = gives;
  claim.known.insert(claim.known.end(), solution.solution.begin(), solution.solution.end());
  const Decision comparison = decided(claim, limits, engines);
  if (comparison.verdict == Verdict::proved) {
    solution.assumptions_used = comparison.assumptions_used;
    return solution;
  }
  if (comparison.verdict == Verdict::proved_if) {
    solution.verdict = Verdict::proved_if;
    solution.conditions.insert(solution.conditions.end(), comparison.conditions.begin(),
                               comparison.conditions.end());
    std::sort(solution.conditions.begin(), solution.conditions.end());
    solution.conditions.erase(
        std::unique(solution.conditions.begin(), solution.conditions.end()),
        solution.conditions.end());
    return solution;
  }
  // Not what it is said to be; the second engine then was asked about the comparison.
  Decision result = comparison;
  result.derived = solution.derived;
  result.free = solution.free;
  return result;
}

Decision with_second_opinion(Decision decision, const SolveGoal& goal,
                             const std::vector<Statement>& gives,
                             const std::vector<SymbolPointer>& leaves, const Limits& limits) {
  using Answer = SecondOpinion::Answer;
  if (!is_solved(decision)) return decision;
  SecondOpinion opinion = second_opinion_on_solution(goal, decision.solution, leaves, limits);
  if (opinion.answer == Answer::holds && !gives.empty()) {
    Goal claim = goal.goal;
    claim.statements = gives;
    claim.known.insert(claim.known.end(), decision.solution.begin(), decision.solution.end());
    opinion = second_opinion(claim, limits);
  }
  if (opinion.answer == Answer::holds) decision.evidence = Evidence::both_engines;
  if (opinion.answer == Answer::fails) {
    decision.verdict = Verdict::internal;
    decision.reason = "the engines disagree about the solution: " + opinion.normal_form;
    decision.evidence = Evidence::none;
  }
  return decision;
}

}  // namespace

Decision solved(const SolveGoal& goal, const std::vector<Statement>& gives,
                const std::vector<SymbolPointer>& leaves, const Limits& limits, Engines engines) {
  SolveGoal complete = goal;
  Decision result = guarded(limits, [&](Workspace& workspace) {
    Solver solver{goal, gives, leaves, workspace};
    Decision decision = solver.run();
    complete = solver.goal();
    return decision;
  });
  if (!is_solved(result)) return result;
  // As the verdict is "proved", the free unknowns are free as wholes, and no others are.
  if (result.solution.size() != goal.unknowns.size() - result.free.size()) {
    result.verdict = Verdict::unknown;
    result.reason = "the solution is not a combination of points";
    return result;
  }
  result = compared(std::move(result), complete, gives, limits, engines);
  if (engines == Engines::kernel) return result;
  return with_second_opinion(std::move(result), complete, gives, leaves,
                             limits_of_second_opinion(limits, engines));
}

}  // namespace patchproof
