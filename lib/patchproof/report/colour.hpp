#pragma once

#include <string>

#include <patchproof/claims/verification.hpp>

namespace patchproof {

/// The text in the colour of an outcome: green as expected, yellow not decided, red wrong.
std::string coloured(const std::string& text, Outcome outcome);

/// The text in bold.
std::string bold(const std::string& text);

}  // namespace patchproof
