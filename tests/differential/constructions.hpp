#pragma once

#include "meaning.hpp"

namespace patchproof::differential {

/// What goes into a construction: a value, or a function.
struct Given {
  Value value;
  Function function;
};

/// The patches and curves of the prelude, from other formulas than there: tensor products by
/// de Casteljau's algorithm, the bicubic patches from the conditions at the corners.
/// @throws std::logic_error for a name it does not know.
Function construction(const std::string& name, const std::vector<Given>& given);

/// Built-in functions and definitions whose result is a number, a point or a matrix.
/// @throws std::logic_error for a name it does not know.
Value built_in(const std::string& name, const std::vector<Value>& given);

}  // namespace patchproof::differential
