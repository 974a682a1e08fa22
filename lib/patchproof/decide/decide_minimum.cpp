#include <algorithm>

#include <patchproof/decide/consistency.hpp>
#include <patchproof/decide/decide.hpp>
#include <patchproof/decide/guard.hpp>
#include <patchproof/decide/minimum_search.hpp>
#include <patchproof/decide/witness_words.hpp>
#include <patchproof/kernel/identity.hpp>
#include <patchproof/kernel/polynomial_term.hpp>
#include <patchproof/kernel/readable.hpp>
#include <patchproof/kernel/witness.hpp>
#include <patchproof/symbolic/second_opinion.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

std::string size_in_words(std::size_t n) { return std::to_string(n) + " x " + std::to_string(n); }

// "36/25 (2 times), 27/20": in the order of elimination, equal neighbours together.
std::string pivots_in_words(const std::vector<Rational>& pivots) {
  std::string text;
  for (std::size_t k = 0; k < pivots.size();) {
    std::size_t end = k;
    while (end < pivots.size() && pivots[end] == pivots[k]) ++end;
    text += (text.empty() ? "" : ", ") + to_text(pivots[k]);
    if (end - k > 1) text += " (" + std::to_string(end - k) + " times)";
    k = end;
  }
  return text;
}

class Minimum {
 public:
  Minimum(const MinimumGoal& goal, Workspace& workspace)
      : goal_{goal}, workspace_{workspace}, search_{goal, workspace} {}

  Decision run() {
    Decision result;
    if (search_.hypotheses().contradictory()) {
      result.verdict = Verdict::vacuous;
      result.reason = "the assumptions contradict each other";
      return result;
    }
    if (const std::string doubt = search_.set_up(); !doubt.empty()) {
      result.verdict = Verdict::error;
      result.reason = doubt;
      return result;
    }
    const std::vector<Polynomial>& linear = search_.linear_part();
    for (std::size_t f = 0; f < linear.size(); ++f)
      if (!linear[f].is_zero()) return not_stationary(f);
    const auto hessian = search_.hessian();
    if (!hessian) {
      result = symbolic_hessian();
      if (result.verdict == Verdict::refuted) return result;
      result.reason =
          "the Hessian of the functional contains symbols, and its sign was not settled";
      return result;
    }
    const QuadraticForm form = quadratic_form(*hessian, workspace_.budget);
    if (form.kind == QuadraticForm::Kind::somewhere_negative) return not_convex(form);
    return proof(form);
  }

  // The values of the functional as both engines should see them.
  const Goal& cross_check() const { return cross_check_; }

 private:
  Decision proof(const QuadraticForm& form) {
    Decision result;
    Conditions conditions = search_.conditions();
    if (const std::string doubt = inconsistency(goal_.goal, conditions, search_.hypotheses(), workspace_); !doubt.empty()) {
      result.reason = "no values are known for which all assumptions and conditions hold: " + doubt;
      return result;
    }
    result.verdict = conditions.empty() ? Verdict::proved : Verdict::proved_if;
    result.evidence = Evidence::kernel;
    result.conditions = in_words(conditions, workspace_);
    const std::size_t size = search_.linear_part().size();
    const bool definite = form.kind == QuadraticForm::Kind::positive_definite;
    result.details = {
        {"Hessian",
         size_in_words(size) + (definite ? ", positive definite" : ", positive semidefinite")},
        {"pivots", pivots_in_words(form.pivots)},
        {"minimiser", definite ? std::string{"unique"}
                               : "not unique: " + std::to_string(size - form.pivots.size()) +
                                     " directions do not change the value"}};
    if (form.pivots.empty()) result.details.erase(result.details.begin() + 1);
    result.assumptions_used = used();
    cross_check_ = search_.values_as_claim();
    return result;
  }

  // The assumptions that cannot be taken away one by one without losing the proof.
  std::vector<std::string> used() {
    MinimumGoal rest = goal_;
    std::vector<std::string> labels;
    for (std::size_t k = goal_.goal.assumptions.size(); k-- > 0;) {
      const Assumption assumption = rest.goal.assumptions[k];
      rest.goal.assumptions.erase(rest.goal.assumptions.begin() + static_cast<std::ptrdiff_t>(k));
      if (still_holds(rest)) continue;
      rest.goal.assumptions.insert(rest.goal.assumptions.begin() + static_cast<std::ptrdiff_t>(k),
                                   assumption);
      const std::string name =
          assumption.label.empty() ? "assumption " + std::to_string(k + 1) : assumption.label;
      if (std::find(labels.begin(), labels.end(), name) == labels.end()) labels.push_back(name);
    }
    std::reverse(labels.begin(), labels.end());
    return labels;
  }

  bool still_holds(const MinimumGoal& fewer) {
    try {
      MinimumSearch search{fewer, workspace_};
      if (!search.set_up().empty()) return false;
      const std::vector<Polynomial>& linear = search.linear_part();
      const auto hessian = search.hessian();
      return hessian && search.conditions().size() <= search_.conditions().size() &&
             std::all_of(linear.begin(), linear.end(),
                         [](const Polynomial& p) { return p.is_zero(); }) &&
             quadratic_form(*hessian, workspace_.budget).kind !=
                 QuadraticForm::Kind::somewhere_negative;
    } catch (const NoValue&) {
      return false;
    } catch (const OutsideTheory&) {
      return false;
    }
  }

  Decision not_stationary(std::size_t f) {
    WitnessTarget target;
    add(search_.conditions(), target);
    target.not_zero.push_back(search_.linear_part()[f]);
    Decision result = refutation(target);
    if (result.verdict == Verdict::refuted)
      result.details = {{"first variation", to_text(Fraction{search_.linear_part()[f]},
                                                    workspace_.atoms, workspace_.budget, 300) +
                                                " for each unit of " + search_.direction_name(f)}};
    return result;
  }

  // A Hessian with symbols is looked at only for numbers that make it negative.
  Decision symbolic_hessian() {
    WitnessTarget target;
    add(search_.conditions(), target);
    target.not_zero.push_back(search_.symbolic_entry());
    return refutation(target);
  }

  Decision not_convex(const QuadraticForm& form) {
    WitnessTarget target;
    add(search_.conditions(), target);
    Decision result = refutation(target);
    if (result.verdict == Verdict::refuted)
      result.details = {
          {"Hessian", size_in_words(search_.linear_part().size()) + ", negative in some direction"},
          {"pivots", pivots_in_words(form.pivots)}};
    return result;
  }

  // Numbers for everything that is given, then a competitor that is better than the candidate.
  Decision refutation(const WitnessTarget& target) {
    Decision result;
    result.reason =
        "the candidate is not stationary or not least, but no better competitor was found";
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      std::optional<Witness> witness =
          find_witness(goal_.goal, target, search_.hypotheses(), workspace_, attempt);
      if (!witness) continue;
      const auto better = better_competitor(*witness);
      if (!better) continue;
      for (KnownValue& value : witness->values)
        for (const KnownValue& b : *better)
          if (b.symbol->ordinal == value.symbol->ordinal) value.value = b.value;
      const WitnessCheck check = checked(restricted_goal(), *witness, workspace_.budget);
      if (!check.consistent || !check.refutes) continue;
      result.verdict = Verdict::refuted;
      result.evidence = Evidence::kernel;
      result.reason.clear();
      result.witness = {in_words(*witness), witness->values, check.left, check.right, ""};
      cross_check_ = values_at(*witness);
      return result;
    }
    return result;
  }

  // The functional with the witness put in, and the constraints there.
  Goal values_at(const Witness& witness) {
    const MinimumGoal numeric = with_values(witness.values, {});
    Goal result = MinimumSearch{numeric, workspace_}.values_as_claim();
    result.statements.insert(result.statements.end(), numeric.constraints.begin(),
                             numeric.constraints.end());
    return result;
  }

  // With the constraints among the assumptions, so that the check of a witness includes them.
  Goal restricted_goal() const {
    Goal result = goal_.goal;
    for (const Statement& s : goal_.constraints) result.assumptions.push_back({"constraint", s});
    return result;
  }

  std::optional<std::vector<KnownValue>> better_competitor(const Witness& witness) {
    const MinimumGoal numeric = with_values(witness.values, goal_.unknowns);
    MinimumSearch search{numeric, workspace_};
    if (!search.set_up().empty()) return std::nullopt;
    return search.better_competitor();
  }

  // The goal with numbers and polynomials put in, apart from what stays open.
  MinimumGoal with_values(const std::vector<KnownValue>& values,
                          const std::vector<SymbolPointer>& open) const {
    std::map<unsigned, Term> images;
    for (const KnownValue& value : values) images.emplace(value.symbol->ordinal, value.value);
    for (const SymbolPointer& symbol : open) images.erase(symbol->ordinal);
    // Equations are for all parameters.
    for (const ParameterRange& range : goal_.goal.ranges) images.erase(range.parameter->ordinal);
    const auto put_in = [&](Statement& s) {
      s.left = replaced(s.left, images);
      s.right = replaced(s.right, images);
    };
    MinimumGoal result = goal_;
    result.goal.assumptions.clear();
    for (Statement& s : result.goal.statements) put_in(s);
    for (Statement& s : result.constraints) put_in(s);
    put_in(result.membership);
    for (ParameterRange& range : result.goal.ranges) {
      range.lower = replaced(range.lower, images);
      range.upper = replaced(range.upper, images);
    }
    for (KnownValue& known : result.goal.known) known.value = replaced(known.value, images);
    return result;
  }

  const MinimumGoal& goal_;
  Workspace& workspace_;
  MinimumSearch search_;
  Goal cross_check_;
};

}  // namespace

Decision minimum(const MinimumGoal& goal, const Limits& limits, Engines engines) {
  Goal cross_check;
  Decision result = guarded(limits, [&](Workspace& workspace) {
    Minimum minimum{goal, workspace};
    Decision decision = minimum.run();
    cross_check = minimum.cross_check();
    return decision;
  });
  if (cross_check.statements.empty() || engines == Engines::kernel) return result;
  const SecondOpinion opinion =
      second_opinion(cross_check, limits_of_second_opinion(limits, engines));
  if (opinion.answer == SecondOpinion::Answer::holds) result.evidence = Evidence::both_engines;
  if (opinion.answer == SecondOpinion::Answer::fails) {
    result.verdict = Verdict::internal;
    result.evidence = Evidence::none;
    result.reason = "the engines disagree about the functional: " + opinion.normal_form;
  }
  return result;
}

}  // namespace patchproof
