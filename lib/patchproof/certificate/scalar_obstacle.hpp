#pragma once

#include <string>

#include <patchproof/certificate/scalar.hpp>

namespace patchproof {

/// What the support library cannot calculate with in a side of an equation, once all lambdas are
/// applied; "" when nothing is in the way. An unknown function at a quotient: two arguments are
/// known for equal only when they are so without reducing fractions. An integral: its body has to
/// be a polynomial in the variable of integration.
std::string obstacle_in_equation(const ScalarPointer& scalar);

/// Whether there is a square root: two such numbers are not told apart by calculating.
bool has_root(const ScalarPointer& scalar);

}  // namespace patchproof
