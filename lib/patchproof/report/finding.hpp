#pragma once

#include <string>

#include <patchproof/report/report.hpp>

namespace patchproof {

/// Everything about one claim that needs attention: the statement as written, what was expected
/// and what was found, where the two sides differ, and what may be done about it.
///
///     bad.proof:9:22: coons.bilinear.sum_alone: expected PROVED, found REFUTED
///          9 |   prove   sum_alone: rC(u,0) + rD(u,0) == C1(u)
///            |                      ^^^^^^^^^^^^^^^^^^^^^^^^^^
///            = left - right: D1(0) - u*D1(0) + u*D2(0)
///            = witness: D1(v) = 1; all others 0
///            = left side: 1
///            = right side: 0
std::string finding(const Case& of, const ClaimResult& result);

}  // namespace patchproof
