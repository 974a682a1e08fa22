#pragma once

#include <patchproof/derivation/checked_derivation.hpp>

namespace patchproof {

/// How much of a derivation is written down.
enum class Detail {
  result = 1,  ///< statements and results only
  steps = 2,   ///< the steps a book prints; of a family of claims the first instance
  all = 3,     ///< every definition on its own, all instances
};

/// One claim with its derivation.
struct ClaimDerivation {
  /// Index of the claim in `CaseResult::claims`.
  std::size_t claim = 0;
  /// How many further instances of the same family are not written down.
  std::size_t further_instances = 0;
  CheckedDerivation derivation;
};

/// A case with its derivations, ready to be typeset.
struct CaseDerivation {
  LatexNames names;
  /// What the names of the case stand for.
  CheckedDerivation definitions;
  std::vector<ClaimDerivation> claims;
};

/// The derivations of the claims of a case; each step is decided.
CaseDerivation case_derivation(const CaseResult& result, Detail detail, Engines engines);

}  // namespace patchproof
