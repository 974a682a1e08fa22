#pragma once

#include <cstdint>
#include <random>
#include <vector>

/// Claims made at random, and what else has an opinion about them.
namespace patchproof::differential {

/// Everything a generator leaves to chance, one decision after the other, and remembered.
///
/// What was generated can be generated again from the decisions alone, and something smaller from
/// fewer and smaller ones. So whatever a generator promises (well typed, true) also holds for what
/// is left after shrinking.
class Choices {
 public:
  /// New decisions, the same for the same seed on every machine.
  explicit Choices(std::uint64_t seed) : random_{seed}, free_{true} {}
  /// These decisions again, and 0 for ever after.
  explicit Choices(std::vector<std::uint64_t> decisions)
      : random_{0}, free_{false}, given_{std::move(decisions)} {}

  /// A number from 0 to bound - 1, each as likely.
  std::uint64_t below(std::uint64_t bound);
  /// Whether something happens that happens once in `times`; 0 decides against it.
  bool once_in(std::uint64_t times) { return below(times) == times - 1; }

  template <typename Thing>
  const Thing& one_of(const std::vector<Thing>& things) {
    return things.at(below(things.size()));
  }

  /// The decisions made so far.
  const std::vector<std::uint64_t>& made() const { return made_; }

 private:
  // The standard fixes what this engine gives; it does not fix the distributions.
  std::mt19937_64 random_;
  bool free_;
  std::vector<std::uint64_t> given_;
  std::vector<std::uint64_t> made_;
};

}  // namespace patchproof::differential
