#pragma once

#include <string>
#include <vector>

#include <patchproof/report/record.hpp>

namespace patchproof {

/// One line of a text report: a claim, or all instances of a family with the same answer.
struct ClaimLine {
  std::string id;
  /// The first, or the only, one.
  const ClaimRecord* claim = nullptr;
  std::size_t instances = 1;
};

/// The claims of a case, line by line, in the order of the text.
///
/// Instances of one family share a line where their answers are the same; where the answers of a
/// family differ, each instance that needs attention has a line of its own. The lines point into
/// the case.
std::vector<ClaimLine> claim_lines(const CaseRecord& given, bool strict);

}  // namespace patchproof
