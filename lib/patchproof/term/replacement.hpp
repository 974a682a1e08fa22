#pragma once

#include <map>
#include <vector>

#include <patchproof/term/goal.hpp>

namespace patchproof {

/// The symbols that occur in the term other than as formal parameters of a lambda around them,
/// by ordinal.
std::map<unsigned, SymbolPointer> free_symbols(const Term& term);

/// The same for everything a goal says.
std::map<unsigned, SymbolPointer> free_symbols(const Goal& goal);

/// The term with free symbols replaced by terms of the same type, all at once. The replacements
/// must not contain symbols that are formal parameters where they are put.
Term replaced(const Term& term, const std::map<unsigned, Term>& images);

}  // namespace patchproof
