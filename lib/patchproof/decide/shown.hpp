#pragma once

#include <string>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/term/term.hpp>

namespace patchproof {

/// The normal form of a term in words, component by component; functions at their own parameters.
/// Where there is none: "no value: division by zero", "not computed: limit: …".
std::string normal_form_in_words(const Term& term, const Limits& limits);

}  // namespace patchproof
