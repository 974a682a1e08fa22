#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/term/term.hpp>

namespace patchproof {

enum class Relation { equal, not_equal, less, less_equal, greater, greater_equal };

/// `left relation right`: two terms of one type (scalar, point or matrix; no functions).
/// The orders only between scalars.
struct Statement {
  Term left;
  Relation relation = Relation::equal;
  Term right;
  Span span;
};

/// A statement that may be used without proof, for every value of the parameters in it.
struct Assumption {
  /// The label it was given, or "" ; several statements may share a label.
  std::string label;
  Statement statement;
};

/// lower <= parameter <= upper, for every value of the symbols in the bounds.
struct ParameterRange {
  SymbolPointer parameter;
  Term lower;
  Term upper;
};

/// A symbol whose value is known from an earlier `derive`; a point or a scalar.
struct KnownValue {
  SymbolPointer symbol;
  Term value;
};

/// All statements hold for all parameters in their ranges and all symbols, if the assumptions do.
struct Goal {
  std::vector<Statement> statements;
  std::vector<Assumption> assumptions;
  std::vector<ParameterRange> ranges;
  std::vector<KnownValue> known;
};

/// Which values of `unknowns` satisfy the goal's statements (all of them equations) identically
/// in the parameters? Symbols that are not unknown are given.
struct SolveGoal {
  Goal goal;
  std::vector<SymbolPointer> unknowns;
};

}  // namespace patchproof
