#include <algorithm>

#include <patchproof/decide/consistency.hpp>
#include <patchproof/decide/decide.hpp>
#include <patchproof/decide/guard.hpp>
#include <patchproof/decide/sign_words.hpp>
#include <patchproof/decide/witness_words.hpp>
#include <patchproof/grid/grid_proof.hpp>
#include <patchproof/kernel/identity.hpp>
#include <patchproof/kernel/readable.hpp>
#include <patchproof/kernel/witness.hpp>
#include <patchproof/symbolic/second_opinion.hpp>

namespace patchproof {

namespace {

// The witness was checked in the terms: that is the proof.
Decision refutation_by(const Witness& witness, const WitnessCheck& check, const Goal& goal) {
  Decision result;
  result.verdict = Verdict::refuted;
  result.evidence = Evidence::kernel;
  result.statement = check.statement;
  const Type& type = goal.statements[check.statement].left.type();
  result.witness = {in_words(witness), witness.values, check.left, check.right,
                    component_name(type, check.component)};
  return result;
}

class Identity {
 public:
  Identity(const Goal& goal, Workspace& workspace)
      : goal_{goal},
        workspace_{workspace},
        evaluator_{workspace, goal.known},
        everything_(goal.assumptions.size(), true),
        hypotheses_{goal, everything_, evaluator_, workspace} {}

  Decision run() {
    Decision result;
    if (hypotheses_.contradictory()) {
      result.verdict = Verdict::vacuous;
      result.reason = "the assumptions contradict each other";
      return result;
    }
    const Finding found = finding(goal_, evaluator_, hypotheses_, workspace_);
    if (found.outcome == Finding::Outcome::holds) return proof(found);
    return refutation(found);
  }

 private:
  Decision proof(const Finding& found) {
    Decision result;
    if (const std::string doubt = inconsistency(goal_, found.conditions, hypotheses_, workspace_);
        !doubt.empty()) {
      result.reason = "no values are known for which all assumptions and conditions hold: " + doubt;
      return result;
    }
    result.verdict = found.conditions.empty() ? Verdict::proved : Verdict::proved_if;
    result.evidence = Evidence::kernel;
    result.conditions = in_words(found.conditions, goal_.statements, workspace_);
    result.assumptions_used = used(found);
    result.subdivision = found.tree;
    return result;
  }

  // The assumptions that cannot be taken away one by one without losing the proof.
  std::vector<std::string> used(const Finding& all) {
    std::vector<bool> enabled = everything_;
    for (std::size_t k = enabled.size(); k-- > 0;) {
      enabled[k] = false;
      if (!still_holds(enabled, all.conditions)) enabled[k] = true;
    }
    std::vector<std::string> labels;
    for (std::size_t k = 0; k < enabled.size(); ++k) {
      if (!enabled[k]) continue;
      const std::string& label = goal_.assumptions[k].label;
      const std::string name = label.empty() ? "assumption " + std::to_string(k + 1) : label;
      if (std::find(labels.begin(), labels.end(), name) == labels.end()) labels.push_back(name);
    }
    return labels;
  }

  bool still_holds(const std::vector<bool>& enabled, const Conditions& conditions) {
    try {
      Hypotheses fewer{goal_, enabled, evaluator_, workspace_};
      const Finding found = finding(goal_, evaluator_, fewer, workspace_);
      return found.outcome == Finding::Outcome::holds &&
             found.conditions.size() <= conditions.size();
    } catch (const NoValue&) {
      return false;
    } catch (const OutsideTheory&) {
      return false;
    }
  }

  Decision refutation(const Finding& found) {
    Decision result;
    WitnessTarget target;
    add(found.conditions, target);
    if (found.outcome == Finding::Outcome::fails)
      target.not_zero.push_back(found.residual.numerator());
    else
      violate(found, target);
    target.preferred = found.sign.point;
    std::string why;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      const std::optional<Witness> witness =
          find_witness(goal_, target, hypotheses_, workspace_, attempt);
      if (!witness) continue;
      const WitnessCheck check = checked(goal_, *witness, workspace_.budget);
      if (check.consistent && check.refutes) return refuted(found, *witness, check);
      if (!check.why_not.empty()) why = check.why_not;
    }
    result.reason = undecided(found, why);
    return result;
  }

  // What has to be true for an inequality to fail.
  static void violate(const Finding& found, WitnessTarget& target) {
    const Polynomial& d = found.residual.numerator();
    if (found.asked) {
      target.inequalities.push_back({scaled(found.asked->polynomial, -1), !found.asked->strict});
    } else if (found.sign.kind != SignAnswer::Kind::zero &&
               found.sign.kind != SignAnswer::Kind::only_zero) {
      target.inequalities.push_back({d, false});
      target.inequalities.push_back({scaled(d, -1), false});
    }
  }

  Decision refuted(const Finding& found, const Witness& witness, const WitnessCheck& check) {
    Decision result = refutation_by(witness, check, goal_);
    result.residual = to_text(found.residual, workspace_.atoms, workspace_.budget);
    if (check.statement == found.statement && found.outcome == Finding::Outcome::open)
      result.reason =
          nowhere_worse(goal_.statements[found.statement].relation, found.sign, workspace_);
    return result;
  }

  std::string undecided(const Finding& found, const std::string& why) {
    if (!hypotheses_.left_out().empty()) return hypotheses_.left_out().front();
    if (found.outcome == Finding::Outcome::open)
      return undecided_sign(goal_.statements[found.statement].relation, found.sign, workspace_);
    const std::string normal = to_text(found.residual, workspace_.atoms, workspace_.budget, 200);
    return "the difference " + normal + " was neither shown to be zero nor to differ from it" +
           (why.empty() ? "" : " (" + why + ")");
  }

  const Goal& goal_;
  Workspace& workspace_;
  Evaluator evaluator_;
  std::vector<bool> everything_;
  Hypotheses hypotheses_;
};

bool only_equations(const Goal& goal) {
  return std::all_of(goal.statements.begin(), goal.statements.end(),
                     [](const Statement& s) { return s.relation == Relation::equal; });
}

// The second engine cannot change a verdict, only confirm it or show that this program is wrong.
Decision with_second_opinion(Decision decision, const Goal& goal, const Limits& limits) {
  const bool proved = decision.verdict == Verdict::proved || decision.verdict == Verdict::proved_if;
  if (!proved && decision.verdict != Verdict::refuted) return decision;
  if (!only_equations(goal)) return decision;
  const SecondOpinion opinion = second_opinion(goal, limits);
  using Answer = SecondOpinion::Answer;
  if (opinion.answer == Answer::none) return decision;
  const Answer expected = proved ? Answer::holds : Answer::fails;
  if (opinion.answer == expected) {
    decision.evidence = Evidence::both_engines;
    return decision;
  }
  decision.reason = "the engines disagree: kernel " +
                    (proved ? std::string{"0"} : decision.residual) + ", second engine " +
                    (proved ? opinion.normal_form : std::string{"0"});
  decision.verdict = Verdict::internal;
  decision.evidence = Evidence::none;
  return decision;
}

// Values that the grid has found, put into the terms: a proof that the statement is false, though
// without the difference of the sides, and the values are not the simplest.
std::optional<Decision> refuted_at(const std::vector<KnownValue>& values, const Goal& goal,
                                   Budget& budget) {
  const Witness witness{values};
  const WitnessCheck check = checked(goal, witness, budget);
  if (!check.consistent || !check.refutes) return std::nullopt;
  return refutation_by(witness, check, goal);
}

// With fractions, if that takes no more than so many steps.
std::optional<Decision> refuted_soon(const Goal& goal, Budget& budget) {
  constexpr std::uint64_t most_steps = 1'000'000;
  Limits limits = budget.limits();
  if (limits.steps != 0 && limits.steps <= most_steps) return std::nullopt;
  limits.steps = most_steps;
  Budget small{limits};
  Workspace workspace{small};
  try {
    Decision result = Identity{goal, workspace}.run();
    if (result.verdict == Verdict::refuted) return result;
  } catch (const OverBudget&) {
    budget.spend(most_steps);
  }
  return std::nullopt;
}

// What is shown on a grid needs no fractions; everything else does.
Decision decided_by_kernel(const Goal& goal, Workspace& workspace) {
  const GridAnswer answer = answer_on_grid(goal, workspace.budget);
  if (answer.kind == GridAnswer::Kind::differs) {
    if (std::optional<Decision> result = refuted_soon(goal, workspace.budget)) return *result;
    if (std::optional<Decision> result = refuted_at(answer.values, goal, workspace.budget))
      return *result;
  }
  if (answer.kind != GridAnswer::Kind::holds) return Identity{goal, workspace}.run();
  Decision result;
  result.verdict = Verdict::proved;
  result.evidence = Evidence::kernel;
  return result;
}

}  // namespace

Decision decided(const Goal& goal, const Limits& limits, Engines engines) {
  Decision result =
      guarded(limits, [&](Workspace& workspace) { return decided_by_kernel(goal, workspace); });
  if (engines == Engines::kernel) return result;
  return with_second_opinion(std::move(result), goal, limits_of_second_opinion(limits, engines));
}

}  // namespace patchproof
