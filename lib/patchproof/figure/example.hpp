#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <patchproof/claims/verification.hpp>
#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

/// What holds in one instance of a case.
struct CaseFacts {
  std::vector<Assumption> assumptions;
  std::vector<ParameterRange> ranges;
  /// Values of unknowns that were derived: of each the first derivation.
  std::vector<KnownValue> derived;
};

/// The assumptions and ranges written in the case, and what was derived.
CaseFacts facts_of(const CaseResult& result, const std::string& instance);

/// Values for all that a case leaves open, in three copies: points of any dimension have one
/// coordinate in each.
struct Example {
  std::array<std::vector<KnownValue>, 3> values;
  /// Names without indices of what got a value, in the order of declaration.
  std::vector<std::string> names;
};

/// An example that satisfies the assumptions, for all symbols that occur in the terms; empty when
/// none was found.
/// @throws NoValue, OutsideTheory, FinerAngles, OverBudget
std::optional<Example> example_of(const std::vector<Term>& terms, const CaseFacts& facts,
                                  Workspace& workspace);

}  // namespace patchproof
