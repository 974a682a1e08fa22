#pragma once

#include <vector>

#include <patchproof/term/goal.hpp>

namespace patchproof {

/// One side of a joint: a curve or patch, which of its parameters is fixed there, and where.
struct JointEdge {
  Term function;
  std::size_t crossing = 0;  ///< the parameter that is fixed on the edge
  Term value;                ///< the end of its range
  bool at_end = true;        ///< the upper end, not the lower one
};

/// A partial derivative at the edge: `across` times in the parameter that is fixed there, `beside`
/// times in the one along the edge (patches).
///
/// `along` are terms for the parameters along the edge (none for curves). With `reversed` the
/// direction across the edge is turned round, so that odd derivatives across change their sign.
Term edge_derivative(const JointEdge& edge, int across, int beside, bool reversed,
                     const std::vector<Term>& along, const Span& span);

/// The equations of a C^order joint: positions and derivatives across the edge agree, up to the
/// order, for all values of the parameters along the edge.
///
/// `along` are terms for the parameters along the edge (none for curves). Passing the edge from the
/// first side to the second must keep going forward: where a side is left through the start of its
/// range, its odd derivatives change sign. Parameter lengths are taken as they are.
/// Source: Farin, Curves and Surfaces for CAGD, ch. 7.
std::vector<Statement> joint_equations(const JointEdge& first, const JointEdge& second, int order,
                                       const std::vector<Term>& along, const Span& span);

}  // namespace patchproof
