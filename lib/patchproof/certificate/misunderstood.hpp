#pragma once

#include <string>
#include <vector>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/claims/claim.hpp>

namespace patchproof {

/// A claim that Rocq took for something else than what was asked.
struct Misunderstanding {
  std::string claim;
  /// "premise 2: Rocq understood 0 where 1 was asked, in C1 0 = D1 0"
  std::string what;
};

/// Compares what coqc has printed of the file of a case, see `rocq_file`, with what its certificates
/// were asked to show: the same variables in the same order, the same premises, relations and values,
/// once definitions are unfolded and functions applied. The names of variables play no part.
///
/// One entry for each claim that was understood otherwise, not printed, or cannot be read.
std::vector<Misunderstanding> misunderstood(const Case& given,
                                            const std::vector<Certificate>& certificates,
                                            const std::string& printed);

}  // namespace patchproof
