#pragma once

#include <stdexcept>

#include <patchproof/derivation/derivation.hpp>

namespace patchproof {

/// Thrown when a link of a proposed derivation does not hold: a fault of this program.
class FalseStep : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// A link with what the engines say of it.
struct CheckedLink {
  Link link;
  /// Proved, or proved under conditions.
  Decision decision;
};

struct CheckedChain {
  Term start;
  std::vector<CheckedLink> links;
};

struct CheckedPassage {
  Passage::Kind kind = Passage::Kind::computation;
  std::vector<CheckedChain> chains;
  std::vector<KnownValue> values;
  bool open = false;
};

/// A derivation every relation of which was decided; only this can be typeset.
///
/// It cannot be changed, and there is no other way to make one than to decide its links.
class CheckedDerivation {
 public:
  CheckedDerivation() = default;

  /// Decides every link of the passages, but for open conditions, which are not said to hold.
  ///
  /// Links that the engines leave open are left out, and what stands around them is decided
  /// directly; a chain without a link left is left out, and so is a passage without chains and values.
  /// @throws FalseStep when a link is refuted, or has no value.
  CheckedDerivation(const Derivation& proposed, const Limits& limits, Engines engines);

  const std::vector<CheckedPassage>& passages() const { return passages_; }

 private:
  std::vector<CheckedPassage> passages_;
};

}  // namespace patchproof
