#pragma once

#include <patchproof/certificate/scalar.hpp>

namespace patchproof {

/// Whether an unknown function is applied, once all lambdas are, to something that is divided by more
/// than a number. The support library knows two such arguments for equal only when they are so without
/// reducing fractions.
bool has_quotient_argument(const ScalarPointer& scalar);

}  // namespace patchproof
