#pragma once

#include <patchproof/net/segment_plan.hpp>

namespace patchproof {

/// Whether the weights of a direction are right for every net over these knots, whatever its
/// points: the difference of derivatives at each seam, up to the order that splines have there, is
/// a combination of control points with weights that are all 0, and the way back from the Bézier
/// points leads each control point to itself. Exact, and as fast for nets of any size of numbers.
bool holds_for_every_net(const DirectionPlan& plan);

}  // namespace patchproof
