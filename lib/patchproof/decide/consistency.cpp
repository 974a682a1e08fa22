#include <patchproof/decide/consistency.hpp>

namespace patchproof {

void add(const Conditions& conditions, WitnessTarget& target) {
  for (const Condition& c : conditions) {
    if (c.kind == Condition::Kind::not_zero)
      target.not_zero.push_back(c.polynomial);
    else
      target.inequalities.push_back({c.polynomial, false});
  }
}

std::string inconsistency(const Goal& goal, const Conditions& conditions, Hypotheses& hypotheses,
                          Workspace& workspace) {
  if (goal.assumptions.empty() && conditions.empty()) return "";
  std::string why = "no example was found";
  WitnessTarget target;
  add(conditions, target);
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    const std::optional<Witness> model =
        find_witness(goal, target, hypotheses, workspace, attempt);
    if (!model) continue;
    const WitnessCheck check = checked(goal, *model, workspace.budget);
    if (check.consistent) return "";
    why = check.why_not;
  }
  return why;
}

}  // namespace patchproof
