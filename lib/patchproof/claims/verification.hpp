#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <patchproof/claims/claim.hpp>
#include <patchproof/claims/joint_report.hpp>

namespace patchproof {

/// How the verdict of a claim stands to what its author expects.
enum class Outcome {
  as_expected,
  wrong,     ///< the claim is decided, but otherwise than expected
  unknown,   ///< not decided, though a decision is expected
  vacuous,   ///< the assumptions contradict each other
  error,     ///< the claim has no meaning: division by zero and the like
  internal,  ///< a fault of this program
};

/// A claim with its verdict.
struct ClaimResult {
  Claim claim;
  Decision decision;
  Outcome outcome = Outcome::unknown;
  std::chrono::microseconds time{0};
  /// What the derivations it uses have found, those of its own instance.
  std::vector<KnownValue> known = {};
  /// Where two of them have found a value of one unknown: that the values agree.
  std::vector<Assumption> agreements = {};
};

/// What `show` asked for: the term as written and its normal form, or why it has none; of a joint
/// what is known of it, in words in `value`.
struct ShownResult {
  Span span;
  std::string instance;
  std::string term;
  std::string value;
  std::optional<JointReport> joint;
};

/// A case with all its claims decided, in the order written.
struct CaseResult {
  Case verified;
  std::vector<ClaimResult> claims;
  std::vector<ShownResult> shown;
};

/// Decides the claims of a case in any order. A derivation that a claim uses is decided when it is
/// first needed, and once.
class CaseVerifier {
 public:
  /// The case has to live as long. `begins` is called before each decision.
  CaseVerifier(const Case& given, Engines engines, std::function<void()> begins = {});

  /// Decides the claim of this index.
  ClaimResult decided(std::size_t index);
  /// Describes what this `show` of the case asks for.
  ShownResult described(std::size_t index) const;

 private:
  std::optional<std::size_t> derivation_for(const std::string& label, const std::string& instance,
                                            std::size_t before) const;
  std::set<std::size_t> derivations_below(std::size_t index) const;
  ClaimResult decide(std::size_t index) const;
  Decision decision_of(std::size_t index, ClaimResult& result) const;

  const Case& given_;
  Engines engines_;
  std::function<void()> begins_;
  /// Label -> instance -> index of the derivation.
  std::map<std::string, std::map<std::string, std::size_t>> derivations_;
  std::map<std::size_t, ClaimResult> decided_derivations_;
};

struct VerificationOptions {
  Engines engines = Engines::both;
  /// Claims for which this is false are not reported. Empty: all are.
  std::function<bool(const Claim&)> wanted;
  /// Called before each claim that is decided.
  std::function<void(const Claim&)> progress;
};

/// Decides the claims of a case one after the other; `using` hands on what was derived.
CaseResult verified(const Case& given, const VerificationOptions& options);

Outcome outcome_of(Expectation expectation, Verdict verdict);

}  // namespace patchproof
