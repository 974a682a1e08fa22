#pragma once

#include <string>
#include <vector>

#include <patchproof/repair/edit.hpp>
#include <patchproof/repair/line.hpp>
#include <patchproof/repair/names.hpp>

namespace patchproof {

/// One curve taken backwards wherever a statement names it: C(0) becomes C(1), C(u) becomes C(1-u).
/// A person counts this as one change: four curves of a patch that do not close often have one
/// that runs the wrong way.
struct Reversal {
  std::string curve;
  std::vector<Edit> edits;
};

/// The reversals of all curves the statement names more than once, in the order of the text.
/// Curves whose derivatives occur are left out.
std::vector<Reversal> reversals_of(const Line& line, const Names& names);

}  // namespace patchproof
