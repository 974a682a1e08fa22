#pragma once

#include <optional>

#include <patchproof/term/term.hpp>

namespace patchproof {

/// The derivative of a value in one of its symbols, by the rules a reader knows: summand by summand,
/// factor by factor, functions by the chain rule. Nothing is expanded.
///
/// Only a proposal for a step of a derivation, which the engines decide. Empty for what has no rule
/// here: integrals and determinants of the symbol, basis functions of splines.
std::optional<Term> differentiated(const Term& value, const SymbolPointer& symbol);

}  // namespace patchproof
