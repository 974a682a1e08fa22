#include <patchproof/claims/joint_report.hpp>

#include <algorithm>

#include <patchproof/claims/geometric_joint.hpp>
#include <patchproof/decide/decide.hpp>
#include <patchproof/decide/polynomial_degree.hpp>

namespace patchproof {

namespace {

constexpr int highest_order = 12;
constexpr std::size_t longest_difference = 300;

std::string shortened(const std::string& text) {
  if (text.size() <= longest_difference) return text;
  return text.substr(0, text.rfind(' ', longest_difference)) + " …";
}

class Asking {
 public:
  Asking(const JointQuestion& question, const Limits& limits)
      : question_{question}, limits_{limits} {}

  JointReport report() {
    result_.span = question_.span;
    parametric();
    if (!result_.parametric) return result_;
    geometric();
    return result_;
  }

 private:
  Decision answer(std::vector<Statement> statements) {
    Goal goal = question_.given;
    goal.statements = std::move(statements);
    // The second engine would only repeat what the claims of the case ask it for.
    return decided(goal, limits_, Engines::kernel);
  }

  // Notes the conditions of what holds.
  bool holds(const Decision& decision) {
    if (decision.verdict == Verdict::proved) return true;
    if (decision.verdict != Verdict::proved_if) return false;
    for (const std::string& condition : decision.conditions)
      if (std::find(result_.conditions.begin(), result_.conditions.end(), condition) ==
          result_.conditions.end())
        result_.conditions.push_back(condition);
    return true;
  }

  static std::string why_not(const std::string& order, const Decision& decision,
                             const std::vector<Statement>& statements) {
    if (decision.verdict != Verdict::refuted)
      return order + " is not decided: " +
             (decision.reason.empty() ? to_text(decision.verdict) : decision.reason);
    const std::string where =
        decision.witness.component.empty() ? "" : " in " + decision.witness.component;
    const bool equation = statements[decision.statement].relation == Relation::equal;
    if (equation)
      return "not " + order + ": left - right = " + shortened(decision.residual) + where;
    return "not " + order + ": no alpha > 0, as " + shortened(decision.residual) +
           " is not positive";
  }

  void parametric() {
    const std::optional<unsigned> highest = degree_across();
    for (int order = 0; order <= highest_order; ++order) {
      if (highest && order > static_cast<int>(*highest)) {
        result_.one_polynomial = true;
        return;
      }
      std::vector<Statement> all = joint_equations(question_.first, question_.second, order,
                                                   question_.along, question_.span);
      const std::vector<Statement> last{all.back()};
      const Decision decision = answer(last);
      if (!holds(decision)) {
        result_.next_parametric = why_not("C^" + std::to_string(order), decision, last);
        return;
      }
      result_.parametric = order;
    }
    result_.at_least = true;
  }

  // The higher degree of the two sides across the edge; empty when one is no polynomial.
  std::optional<unsigned> degree_across() {
    const auto first =
        polynomial_degree(question_.first.function, question_.first.crossing, limits_);
    const auto second =
        polynomial_degree(question_.second.function, question_.second.crossing, limits_);
    if (!first || !second) return std::nullopt;
    return std::max(*first, *second);
  }

  void geometric() {
    if (why_not_geometric(question_.first)) return;
    result_.geometric = 0;
    for (int order = 1; order <= highest_geometric_order; ++order) {
      const std::vector<Statement> statements = geometric_joint(
          question_.first, question_.second, order, question_.along, {}, question_.span);
      const Decision decision = answer(statements);
      if (!holds(decision)) {
        result_.next_geometric = why_not("G^" + std::to_string(order), decision, statements);
        return;
      }
      result_.geometric = order;
    }
  }

  const JointQuestion& question_;
  const Limits& limits_;
  JointReport result_;
};

}  // namespace

JointReport joint_report(const JointQuestion& question, const Limits& limits) {
  return Asking{question, limits}.report();
}

std::string in_words(const JointReport& report) {
  std::string text;
  const auto add = [&](const std::string& part, const std::string& before) {
    if (!part.empty()) text += (text.empty() ? "" : before) + part;
  };
  if (report.one_polynomial) {
    add("C^infinity: one polynomial", "");
  } else if (report.parametric) {
    add("C^" + std::to_string(*report.parametric) + (report.at_least ? " at least" : ""), "");
  }
  if (report.geometric) add("G^" + std::to_string(*report.geometric), ", ");
  for (std::size_t k = 0; k < report.conditions.size(); ++k)
    text += (k == 0 ? " if " : ", ") + report.conditions[k];
  add(report.next_parametric, "; ");
  add(report.next_geometric, "; ");
  return text;
}

}  // namespace patchproof
