#pragma once

#include <array>
#include <optional>
#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/grid/tape.hpp>

namespace patchproof {

/// Where a variable is looked at: at `start` and as many times a part of `length` further as its
/// degree, the last time at `start + length`.
struct GridRange {
  Rational start{0};
  Rational length{1};
};
using GridRanges = std::array<GridRange, Tape::most_variables>;

/// Something that is not zero.
struct GridDifference {
  /// The values of the variables.
  std::array<Rational, Tape::most_variables> point;
  /// The coefficient of this symbol is not zero there; without one, what has no symbols.
  std::optional<std::uint32_t> symbol;
};

/// Whether all steps are zero identically; see `answer_on_grid`.
/// @throws Declined when that would be too much work.
/// @throws OverBudget
bool are_zero(const Tape& tape, const std::vector<Tape::Step>& steps, Budget& budget);

/// Where one of these steps differs from zero at one point in the ranges; nothing when all are zero
/// there, or primes divide numbers.
/// @throws Declined when there are too many values.
/// @throws OverBudget
std::optional<GridDifference> difference_at_a_point(const Tape& tape,
                                                    const std::vector<Tape::Step>& steps,
                                                    const GridRanges& ranges, Budget& budget);

/// Where one of these steps differs from zero, which `are_zero` has said of them; nothing when
/// primes divide the numbers of the tape.
/// @throws OverBudget
std::optional<GridDifference> difference_from_zero(const Tape& tape,
                                                   const std::vector<Tape::Step>& steps,
                                                   const GridRanges& ranges, Budget& budget);

}  // namespace patchproof
