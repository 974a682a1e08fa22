#pragma once

#include <string>

#include <patchproof/kernel/sign_facts.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof {

/// Of a refuted inequality left < right: "right - left is never negative on the box; zero at u = 0"
/// where that is all that is wrong with it, otherwise "".
std::string nowhere_worse(Relation relation, const SignAnswer& answer, const Workspace& workspace);

/// Why an inequality was neither proved nor refuted.
std::string undecided_sign(Relation relation, const SignAnswer& answer, const Workspace& workspace);

}  // namespace patchproof
