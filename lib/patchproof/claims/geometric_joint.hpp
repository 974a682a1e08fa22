#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/claims/joint.hpp>

namespace patchproof {

/// The highest order of geometric continuity that is written out.
inline constexpr int highest_geometric_order = 2;

/// How many connecting functions a G^order joint has: alpha, gamma, beta, delta of patches, alpha
/// and beta of curves; those of the first derivatives come first.
std::size_t connecting_function_count(const JointEdge& edge, int order);

/// Why no G^order joint of these functions can be stated without its connecting functions; empty
/// when it can: for curves and patches in R^2 and R^3.
std::optional<std::string> why_not_geometric(const JointEdge& edge);

/// What a G^order joint, order 0 to 2, means for P up to the edge and R beyond it; v and t go
/// across the edge, both onward from P to R, and u along it.
///
/// The positions agree, and there are functions of u, the connecting functions, with
///   R_t  == alpha*P_v + gamma*P_u and alpha > 0                                       (order 1)
///   R_tt == alpha^2*P_vv + 2*alpha*gamma*P_uv + gamma^2*P_uu + beta*P_v + delta*P_u   (order 2)
/// For curves the same without u. `functions` are these functions; without them the statements say
/// that there are some, and that P is regular on the edge: n = P_u x P_v is not zero,
///   det(P_u, P_v, R_t) == 0 and dot(n, P_u x R_t) > 0,
/// and that R_tt without its known part lies in the tangent plane, multiplied out by (n.n)^2.
/// Source: Farin, Curves and Surfaces for CAGD, ch. 11 (curves) and 21; Hoschek & Lasser, ch. 7.
std::vector<Statement> geometric_joint(const JointEdge& first, const JointEdge& second, int order,
                                       const std::vector<Term>& along,
                                       const std::vector<Term>& functions, const Span& span);

}  // namespace patchproof
