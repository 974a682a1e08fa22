#pragma once

#include <vector>

#include <patchproof/repair/edit.hpp>
#include <patchproof/repair/line.hpp>

namespace patchproof {

/// The signs within a part of the line turned round: + and - between summands exchanged, a sign of
/// one's own taken away.
std::vector<Edit> sign_edits(const Line& line, const Span& part);

}  // namespace patchproof
