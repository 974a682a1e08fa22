#pragma once

#include <recheck/document.hpp>
#include <recheck/meter.hpp>

namespace recheck {

/// Requires that at the values every hypothesis holds, every parameter is in its range, and the
/// conclusion is false.
/// @throws Rejection, Unsupported, LimitReached
void require_refutation(const Refutation& refutation, const Certificate& certificate, Meter& meter);

}  // namespace recheck
