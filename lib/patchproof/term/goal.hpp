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

/// Does the candidate have the least value of a functional among all competitors?
///
/// The competitors are all values of `competitor` that satisfy the constraints, identically in the
/// parameters; they differ in the values of the unknowns.
struct MinimumGoal {
  /// One statement: value of the functional at the candidate <= value at the competitor.
  Goal goal;
  /// Equations that competitors have to satisfy.
  std::vector<Statement> constraints;
  /// competitor == candidate: values of one type.
  Statement membership;
  /// The control points of the competitor.
  std::vector<SymbolPointer> unknowns;
};

}  // namespace patchproof
