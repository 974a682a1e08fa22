#pragma once

#include <string_view>

#include <patchproof/term/term.hpp>

namespace patchproof {

/// What stands before the parentheses of an operation that is written as a call: "sin", "det", or
/// nothing, as for a tuple.
std::string_view call_name(const Term& term);

}  // namespace patchproof
