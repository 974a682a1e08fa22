#pragma once

#include <stdexcept>
#include <string>

#include <patchproof/derivation/case_derivation.hpp>
#include <patchproof/derivation/claim_derivation.hpp>
#include <patchproof/language/reader.hpp>
#include <tests/cases/case_files.hpp>

/// Derivations of cases/ before anything of them is decided.
namespace patchproof::test {

/// A derivation as proposed, with the names its terms have.
struct Proposal {
  LatexNames names;
  Derivation derivation;
  Limits limits;
};

/// The case of this name below cases/, in a file whose path contains `part`.
/// @throws std::invalid_argument when there is none.
inline Case case_named(const std::string& part, const std::string& name) {
  for (const SourceText& source : case_files(part)) {
    const ReadFile file =
        read_cases(std::make_shared<const SourceText>(source), Limits{}, case_loader());
    for (const Case& given : file.cases)
      if (given.name == name) return given;
  }
  throw std::invalid_argument{"no case " + name};
}

/// What is proposed for the first claim with this label.
inline Proposal proposal(const Case& given, const std::string& label) {
  VerificationOptions options;
  options.engines = Engines::kernel;
  options.wanted = [&](const Claim& claim) { return claim.label == label; };
  const CaseResult result = verified(given, options);
  // Only the names: results have no steps.
  Proposal proposal{
      case_derivation({given, {}, {}}, Detail::result, Engines::kernel).names, {}, given.limits};
  Computation computation{proposal.names, Detail::steps, given.limits};
  proposal.derivation = claim_derivation(result.claims.at(0), {}, computation);
  return proposal;
}

}  // namespace patchproof::test
