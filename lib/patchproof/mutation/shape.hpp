#pragma once

#include <string>
#include <vector>

#include <patchproof/algebra/number.hpp>

namespace patchproof {

/// Points of exact coordinates in rows: a net, or with one row a list of points. All points have
/// one dimension; numbers are points of dimension 1.
using NumericNet = std::vector<std::vector<std::vector<Rational>>>;

/// What is special about a net, in words: that it is symmetric, flat or without twists, so that
/// errors may go unnoticed; one after the other, the strongest first.
std::vector<std::string> shape_of(const std::string& name, const NumericNet& net);

}  // namespace patchproof
