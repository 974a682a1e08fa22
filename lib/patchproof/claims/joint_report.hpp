#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/claims/claim.hpp>

namespace patchproof {

/// How smooth a joint is, as far as it was found out.
struct JointReport {
  /// As written: "joint of P at v = 1 and R at v = 0".
  Span span;
  /// The largest k such that all derivatives across up to the order k agree; empty: not even the
  /// positions do.
  std::optional<int> parametric;
  /// Both sides are polynomials across the edge, and one and the same.
  bool one_polynomial = false;
  /// Higher orders were not asked for.
  bool at_least = false;
  /// The largest k, up to 2, with a G^k joint; empty where the values are not points of R^2 or R^3.
  std::optional<int> geometric;
  /// Why the next orders fail, or were not decided: "C^2: left - right = 2*u in .z".
  std::string next_parametric;
  std::string next_geometric;
  /// What the derivatives agree under: "a != 0".
  std::vector<std::string> conditions;
};

/// Asks for C^0, C^1, … and G^1, G^2 one after the other. Never throws for a well-typed question.
JointReport joint_report(const JointQuestion& question, const Limits& limits);

/// "C^1, G^2; not C^2: left - right = 2*u in .z"
std::string in_words(const JointReport& report);

}  // namespace patchproof
