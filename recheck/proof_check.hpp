#pragma once

#include <recheck/document.hpp>
#include <recheck/meter.hpp>

namespace recheck {

/// Requires that the proof shows its sequent: every component of every conclusion, and that nothing
/// it divides by is zero.
/// @throws Rejection, Unsupported, LimitReached
void require_proof(const Proof& proof, const Certificate& certificate, Meter& meter);

}  // namespace recheck
