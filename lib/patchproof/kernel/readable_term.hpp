#pragma once

#include <optional>

#include <patchproof/kernel/evaluator.hpp>

namespace patchproof {

/// The value as a term in the order a person writes it, see `Arrangement`: 2(1-u)V[0,0] + V[3,0].
///
/// A point is a combination of points where it is one, else a tuple of its coordinates; a matrix
/// has its entries. The type is that of the term the value came from, and no function. Empty when a
/// point of any dimension is no combination of points, nor a number in its place.
std::optional<Term> readable_term(const Value& value, const Type& type, Workspace& workspace);

}  // namespace patchproof
