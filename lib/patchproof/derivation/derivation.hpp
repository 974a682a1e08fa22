#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/claims/verification.hpp>
#include <patchproof/term/goal.hpp>
#include <patchproof/term/latex_text.hpp>

namespace patchproof {

/// Why a relation between two neighbouring terms of a chain holds, for the reader.
struct Reason {
  enum class Kind {
    none,          ///< nothing is said
    definition,    ///< `names` are written out
    derivative,    ///< the derivatives are carried out
    arithmetic,    ///< numbers are worked out, zeros left out, products multiplied out
    assumption,    ///< by the assumptions `names`
    derived,       ///< with what was derived in `names`
    collected,     ///< both are the same polynomial: expanded and collected by unknowns
    value,         ///< the values of the witness are put in
    integration,   ///< the integral is worked out
  };
  Kind kind = Kind::none;
  std::vector<std::string> names;
};

/// `relation term`, after what stands before it in its chain.
struct Link {
  Relation relation = Relation::equal;
  Term term;
  Reason reason;
};

/// start = a = b < c: each link is decided on its own, under the passage's assumptions.
struct Chain {
  Term start;
  std::vector<Link> links;
};

/// One paragraph of a derivation.
struct Passage {
  enum class Kind {
    definition,   ///< what a name stands for
    computation,  ///< a side of a statement is worked out
    condition,    ///< equations that the unknowns have to satisfy
    result,       ///< what was to be shown or found; boxed
    check,        ///< the result is put into the conditions
    difference,   ///< of the two sides of a false equation, for all values
    witness,      ///< `values` at which a statement is false, and both sides there
    variation,    ///< minimality: the difference of the two values
  };
  Kind kind = Kind::computation;
  std::vector<Chain> chains;
  /// Witness: what everything stands for.
  std::vector<KnownValue> values;
  /// Assumptions, ranges and known values under which the chains are decided; no statements.
  Goal given;
  /// Conditions that nothing is known to satisfy: they are not said to hold, and not decided.
  bool open = false;
  /// Where the claim holds under conditions, or without any, its steps need no others: the conditions
  /// they may have. None given: any.
  std::optional<std::vector<std::string>> conditions = std::nullopt;
};

/// The derivation of one claim, as proposed: nothing of it has been decided.
struct Derivation {
  std::vector<Passage> passages;
};

}  // namespace patchproof
