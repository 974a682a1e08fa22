#pragma once

#include <functional>
#include <vector>

#include "expression.hpp"

namespace patchproof::differential {

/// The parts of an expression that may be replaced by something of the same type and value,
/// outermost first: not indices, not running sums, not what a construction is built of.
std::vector<Node> places(const Node& node);

/// The expression with another one in one of its places, counted as in `places`.
Node with_place(const Node& node, std::size_t place, const Node& instead);

}  // namespace patchproof::differential
