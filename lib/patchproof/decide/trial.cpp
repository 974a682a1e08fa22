#include <patchproof/decide/trial.hpp>

#include <new>
#include <optional>

#include <patchproof/kernel/identity.hpp>

namespace patchproof {

namespace {

/// Goals leave terms behind; now and then they are forgotten.
constexpr std::size_t goals_remembered = 500;

}  // namespace

struct Trial::Memory {
  Memory(const Limits& limits, const std::vector<KnownValue>& known)
      : budget{limits}, evaluator{std::in_place, workspace, known} {}

  Budget budget;
  Workspace workspace{budget};
  std::optional<Evaluator> evaluator;
  std::size_t goals = 0;
};

Trial::Trial(const Limits& limits) : limits_{limits} {}
Trial::~Trial() = default;
Trial::Trial(Trial&&) noexcept = default;
Trial& Trial::operator=(Trial&&) noexcept = default;

bool Trial::finds_proof(const Goal& goal) {
  for (;;) {
    try {
      const std::vector<bool> all(goal.assumptions.size(), true);
      Hypotheses hypotheses{goal, all, *memory_->evaluator, memory_->workspace};
      if (hypotheses.contradictory()) return false;
      const Finding found = finding(goal, *memory_->evaluator, hypotheses, memory_->workspace);
      return found.outcome == Finding::Outcome::holds;
    } catch (const FinerAngles&) {
      memory_->budget.spend(1000);
      memory_->evaluator.emplace(memory_->workspace, goal.known);
    }
  }
}

bool Trial::may_hold(const Goal& goal) {
  try {
    if (!memory_ || ++memory_->goals > goals_remembered)
      memory_ = std::make_unique<Memory>(limits_, goal.known);
    memory_->budget = Budget{limits_};
    return finds_proof(goal);
  } catch (const NoValue&) {
    return false;
  } catch (const OutsideTheory&) {
    return false;
  } catch (const OverBudget&) {
  } catch (const TooDeep&) {
  } catch (const std::domain_error&) {
  } catch (const std::bad_alloc&) {
  }
  memory_.reset();
  return false;
}

}  // namespace patchproof
