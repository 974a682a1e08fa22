#pragma once

#include <optional>
#include <vector>

#include <patchproof/term/term.hpp>

namespace patchproof {

/// A knot vector: scalars in the order of their values. Knots are equal when they are written
/// alike; equal ones stand together.
using Knots = std::vector<Term>;

/// Whether two knots are written alike: the same number, or the same expression in the same
/// symbols.
bool same_knot(const Term& a, const Term& b);

/// The sign of b - a, exactly, where it is a number: of sqrt(2) and 1, or of a + 1 and a. Empty
/// when it depends on symbols, or was not settled.
std::optional<int> order_of(const Term& a, const Term& b);

/// For each knot the number of its value among the different values, from 0.
std::vector<int> values_of(const Knots& knots);

/// Whether no knot has a symbol in it.
bool are_numbers(const Knots& knots);

/// Knots that are all numbers, as numbers.
std::vector<Rational> numbers_of(const Knots& knots);

/// The numbers k of the intervals [knots[k], knots[k+1]] that are not empty, inside the domain.
std::vector<int> spans_of(const Knots& knots, int degree);

}  // namespace patchproof
