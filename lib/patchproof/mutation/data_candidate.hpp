#pragma once

#include <string>
#include <vector>

#include <patchproof/mutation/data.hpp>

namespace patchproof {

/// Other numbers in the place of some of the data: each with what it becomes.
struct DataCandidate {
  std::vector<Datum> numbers;
  std::vector<Edit> edits;
  /// Whether it moves ends of curves or edges of patches: if these no longer meet, claims are false
  /// that speak of no number.
  bool moves_ends = false;
};

/// "V[1,1] = (1, 1, 1) in place of (1, 1, 0)": the entries that a candidate changes, with all that
/// is changed in them together.
std::string in_words(const DataCandidate& candidate, const DataCandidate& together);

/// Whether both change the same number.
bool overlaps(const DataCandidate& a, const DataCandidate& b);

/// Both changes; they do not overlap.
DataCandidate both(const DataCandidate& a, const DataCandidate& b);

/// Small changes of the data that hide errors: heights first, because they break planes and rarely
/// anything else; then other coordinates, and any two curves of the case that meet elsewhere.
std::vector<DataCandidate> data_candidates(const std::vector<const Data*>& hiding,
                                           const std::vector<Data>& all);

}  // namespace patchproof
