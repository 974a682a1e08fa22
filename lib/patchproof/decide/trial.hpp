#pragma once

#include <memory>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof {

/// Tells quickly which of many similar goals may have a proof: by their normal forms alone, without
/// witnesses and without second opinion, remembering the values of the terms they share.
///
/// What it turns down, `decided` does not prove within the same limits. What it lets through is not
/// proved by that.
class Trial {
 public:
  /// `limits` are those of one goal. All goals know the same derived values.
  explicit Trial(const Limits& limits);
  ~Trial();
  Trial(Trial&&) noexcept;
  Trial& operator=(Trial&&) noexcept;

  /// Whether the goal may hold; false also when that takes more than the limits allow.
  bool may_hold(const Goal& goal);

 private:
  struct Memory;
  bool finds_proof(const Goal& goal);

  Limits limits_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace patchproof
