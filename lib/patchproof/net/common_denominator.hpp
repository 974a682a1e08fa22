#pragma once

#include <optional>
#include <vector>

#include <patchproof/algebra/rational.hpp>

namespace patchproof {

/// The least common denominator of numbers. Empty when it has more binary digits than `most_bits`;
/// numbers with denominators that have nothing in common would otherwise fill the memory.
std::optional<Integer> common_denominator(const std::vector<Rational>& numbers,
                                          std::size_t most_bits);

}  // namespace patchproof
