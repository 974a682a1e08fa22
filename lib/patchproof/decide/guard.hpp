#pragma once

#include <functional>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/decide/decision.hpp>
#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

/// Runs a decision in a fresh workspace, again whenever angles have to be cut finer, and turns
/// everything that can go wrong into a verdict.
Decision guarded(const Limits& limits, const std::function<Decision(Workspace&)>& decision);

/// "a - b != 0", "1 - u >= 0": the conditions in words, in a fixed order.
std::vector<std::string> in_words(const Conditions& conditions, Workspace& workspace);

/// The same for a claim of these statements. A condition on a parameter they do not name comes from
/// what is assumed of all its values: "a - t != 0 for all t".
std::vector<std::string> in_words(const Conditions& conditions,
                                  const std::vector<Statement>& statements, Workspace& workspace);

/// ".x", "[1,2]", "[1,2].x" or "" : which component of a value of the type this is.
std::string component_name(const Type& type, std::size_t component);

}  // namespace patchproof
