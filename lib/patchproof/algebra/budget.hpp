#pragma once

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace patchproof {

/// How much work one claim may cost. Zero means "no limit".
struct Limits {
  /// Wall-clock time.
  std::chrono::milliseconds time{60'000};
  /// Terms a polynomial may have.
  std::size_t terms = 2'000'000;
  /// Elementary coefficient operations; the limit that makes runs repeatable.
  std::uint64_t steps = 400'000'000;
  /// Memory in bytes, as counted by `bytes_in_use`.
  std::size_t memory = std::size_t{2} << 30;
};

/// Thrown when a claim has used up its budget; the claim's verdict is then UNKNOWN (limit).
class OverBudget : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What is left of the work one claim may cost. Long computations call `spend` as they go.
class Budget {
 public:
  explicit Budget(const Limits& limits);

  /// Notes that work was done.
  /// @throws OverBudget when time, steps or memory have run out.
  void spend(std::uint64_t steps);

  /// Notes that a polynomial of so many terms is about to exist.
  /// @throws OverBudget when that is more than the limit.
  void require_terms(std::size_t terms);

  const Limits& limits() const { return limits_; }

 private:
  Limits limits_;
  std::chrono::steady_clock::time_point end_;
  std::uint64_t steps_ = 0;
  std::uint64_t unchecked_ = 0;
  std::size_t memory_at_start_ = 0;
};

/// Bytes of memory now in use by this program, where the program counts them; otherwise 0.
std::size_t bytes_in_use();

/// Sets the function behind `bytes_in_use`; the program calls it once, before any claim.
void count_bytes_with(std::size_t (*counter)());

}  // namespace patchproof
