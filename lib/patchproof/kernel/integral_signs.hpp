#pragma once

#include <patchproof/kernel/sign_facts.hpp>

namespace patchproof {

/// The facts, and with them that integrals in the polynomial are not negative where their integrand
/// is a sum of positive multiples of squares and the lower end is at most the upper one.
SignFacts with_signs_of_integrals(const SignFacts& facts, const Polynomial& polynomial,
                                  Workspace& workspace);

}  // namespace patchproof
