#pragma once

#include <vector>

#include <patchproof/net/knot_vector.hpp>

namespace patchproof {

/// How the Bézier points of a span come from its control points: point r is the sum of
/// weights[r*(p+1) + a] * d[k-p+a]. It is the blossom of the polynomial at p - r times the begin of
/// the span and r times its end, by de Boor's algorithm, the same as inserting both knots until
/// they occur p times (Boehm). Sources: Farin, Curves and Surfaces for CAGD, chapter 8; Ramshaw,
/// Blossoms are polar forms; Piegl and Tiller, The NURBS Book, section 5.3.
std::vector<Rational> bezier_weights(const KnotVector& knots, std::size_t span);

/// The way back: how control point i, one of those of the span, comes from its Bézier points. It is
/// the blossom at t[i+1], …, t[i+p], here by de Casteljau's algorithm over the span.
std::vector<Rational> control_weights(const KnotVector& knots, std::size_t span, std::size_t i);

}  // namespace patchproof
