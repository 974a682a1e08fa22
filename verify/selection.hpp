#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <patchproof/claims/claim.hpp>

namespace patchproof {

/// Whether a text matches a pattern, in which '*' stands for any characters and '?' for one.
///
/// Nothing else has a meaning of its own, so that "coons.family[i=0]" matches itself.
bool matches(std::string_view pattern, std::string_view text);

/// The claims that `--only` asks for.
class Selection {
 public:
  /// Patterns for ids of claims, with or without instance, for names of cases, or after "tag:" for
  /// tags of cases. Without patterns, everything is selected.
  explicit Selection(std::vector<std::string> patterns) : patterns_{std::move(patterns)} {}

  const std::vector<std::string>& patterns() const { return patterns_; }
  bool everything() const { return patterns_.empty(); }
  bool contains(const Case& of, const Claim& claim) const;
  /// The patterns that no claim of these cases matches.
  std::vector<std::string> unmatched(const std::vector<const Case*>& cases) const;

 private:
  std::vector<std::string> patterns_;
};

}  // namespace patchproof
