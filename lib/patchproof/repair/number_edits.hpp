#pragma once

#include <vector>

#include <patchproof/repair/edit.hpp>
#include <patchproof/repair/line.hpp>

namespace patchproof {

/// What a number is for.
enum class NumberPlace {
  value,     ///< a summand, a coefficient, an entry
  argument,  ///< of a call
  index,     ///< of an array, or the end of a span: a whole number
  exponent,  ///< a small whole number
};

/// All different numbers of a line, smallest first.
std::vector<Rational> numbers_in(const Line& line);

/// Adds what a number may become: its neighbours, 0, 1, its negative, other numbers of the line.
void add_number_edits(const Line& line, const syntax::Expression& number, NumberPlace place,
                      const std::vector<Rational>& others, std::vector<Edit>& edits);

}  // namespace patchproof
