#pragma once

#include <optional>
#include <string>
#include <vector>

#include "example.hpp"

namespace patchproof::differential {

/// What became of an example.
struct Judgement {
  /// "PROVED", as both engines together say it.
  std::string verdict;
  /// UNKNOWN, ERROR, INTERNAL: why.
  std::string reason;
  /// "" when all opinions agree; otherwise what is wrong, without numbers, so that it stays the
  /// same while an example shrinks.
  std::string fault;
};

/// The case read and decided, by both engines and by the kernel alone, and compared with what is
/// known of it. True ones must be proved, near misses refuted; UNKNOWN is no fault, but counted.
Judgement judged(const Example& example);

/// A program that looks at claims in bulk and tells of each whether both sides are equal. A program
/// that checks what `patchproof check` wrote would be another one here.
///
/// Null for those it says nothing about. All examples are one run of the program.
/// @throws std::runtime_error when there is no such program.
std::vector<std::optional<bool>> opinions_of_python(const std::vector<Example>& examples);

}  // namespace patchproof::differential
