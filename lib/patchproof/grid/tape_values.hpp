#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <patchproof/grid/modulus.hpp>
#include <patchproof/grid/tape.hpp>

namespace patchproof {

/// The steps of a tape at one point, modulo a prime. Each value has several parts: first what has
/// no symbols, then the coefficients of the symbols that occur in the step, in their order.
class TapeValues {
 public:
  using Step = Tape::Step;
  using Residue = Modulus::Residue;

  /// @throws Declined when there would be too many parts.
  explicit TapeValues(const Tape& tape);

  /// From now on modulo this prime, which has to live as long; nothing is calculated yet.
  void begin(const Modulus& modulus) { modulus_ = &modulus; }
  void set_variable(std::size_t variable, Residue value) { point_[variable] = value; }
  /// Calculates one step from those it is made of.
  void calculate(Step step);

  /// About how many additions and multiplications that takes.
  std::uint64_t work_of(Step step) const;
  /// Nothing when the step is zero.
  std::optional<std::size_t> first_part_not_zero(Step step) const;

 private:
  std::size_t width_of(Step step) const { return 1 + tape_.support(step).size(); }
  void find_positions();
  void add(std::uint32_t summand, std::uint32_t support, Residue* result) const;
  Residue combined(Residue a, Residue b, bool negative) const {
    return negative ? modulus_->difference(a, b) : modulus_->sum(a, b);
  }

  const Tape& tape_;
  const Modulus* modulus_ = nullptr;
  std::array<Residue, Tape::most_variables> point_{};
  /// Where the parts of each step begin.
  std::vector<std::size_t> places_;
  std::vector<Residue> values_;
  /// For each summand, where its symbols are among those of the sum; where they are the same,
  /// nothing.
  std::vector<std::size_t> first_position_;
  std::vector<std::uint32_t> positions_;
};

}  // namespace patchproof
