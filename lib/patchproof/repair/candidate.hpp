#pragma once

#include <map>
#include <optional>

#include <patchproof/claims/verification.hpp>
#include <patchproof/decide/trial.hpp>
#include <patchproof/language/claim_reader.hpp>

namespace patchproof {

/// Judges statements in the place of a claim, in all instances of its family.
class CandidateJudge {
 public:
  CandidateJudge(const syntax::Case& written, const syntax::Statement& claim, const Case& given,
                 const Library& library, Engines engines);

  /// Whether the statement may be true: it has a meaning everywhere, and its normal forms agree.
  bool may_hold(const syntax::Proposition& proposition);

  /// The verdict over all instances.
  struct Verdicts {
    Verdict verdict = Verdict::unknown;
    Evidence evidence = Evidence::none;
    std::vector<std::string> conditions;
  };
  Verdicts decided(const syntax::Proposition& proposition);

  /// What the statement claims in the first instance; empty when it has no meaning.
  std::vector<Claim> first_claims(const syntax::Proposition& proposition) {
    return reader_.read(0, proposition);
  }
  /// The names known to the claim, and its running indices, which are not among them.
  const Scope& scope() { return reader_.scope(0); }
  const std::vector<std::string>& running() const { return running_; }

 private:
  std::vector<KnownValue> known_to(const Claim& claim) const;

  const Case& given_;
  Engines engines_;
  ClaimReader reader_;
  /// One for each instance of the case, which have different terms.
  std::vector<Trial> trials_;
  std::vector<std::string> running_;
  /// The derivations above a claim that uses some.
  std::vector<Claim> used_;
  std::map<std::pair<std::string, std::string>, Decision> solutions_;
};

}  // namespace patchproof
