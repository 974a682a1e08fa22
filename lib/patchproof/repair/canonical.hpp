#pragma once

#include <string>

#include <patchproof/repair/line.hpp>
#include <patchproof/repair/names.hpp>

namespace patchproof {

/// A comparison as text in which the order of summands and factors, blanks and needless
/// parentheses no longer count: what agrees in it says the same.
std::string canonical(const syntax::Comparison& comparison, const Names& names);

/// Whether a comparison says nothing: some relation has the same on both sides, apart from order
/// and parentheses, or is one between numerals only.
bool is_trivial(const syntax::Comparison& comparison, const Names& names);

}  // namespace patchproof
