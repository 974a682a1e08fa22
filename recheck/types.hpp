#pragma once

#include <recheck/document.hpp>
#include <recheck/meter.hpp>

namespace recheck {

/// Thrown by what is no statement of mathematics: a sum of a point and a number.
class WrongType : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The type of a node, by those of its children; what is given with the node is checked. The type
/// of the node says, as it comes, only the extents of a matrix and whether a tuple is a point of
/// any dimension.
/// @throws WrongType
Type type_of(const Node& node, const std::vector<Node>& nodes, const std::vector<Symbol>& symbols,
             const Limits& limits);

/// The type of a product of two matrices that fit.
Type product_type(const Type& a, const Type& b);

}  // namespace recheck
