#pragma once

#include <vector>

#include <patchproof/symbolic/evaluation.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof::symbolic {

/// The values of known symbols, free of known symbols themselves. A symbol may occur in the term of
/// its own value if it cancels there, as a control point does in the boundary of its patch.
/// @throws OverBudget
/// @throws std::domain_error when values refer to each other in a circle.
SymbolValues values_of(Ring& ring, const std::vector<KnownValue>& known);

}  // namespace patchproof::symbolic
