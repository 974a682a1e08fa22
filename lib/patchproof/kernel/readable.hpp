#pragma once

#include <string>

#include <patchproof/kernel/atoms.hpp>

namespace patchproof {

/// The variable as a person writes it: "u", "V[0,1].x", "C1'(0)", "w_uv(0, v)", "sin(pi*u)".
std::string to_text(Variable variable, const Atoms& atoms);

/// The fraction as a person writes it: collected by the unknowns in the order of their
/// declaration, their coefficients with powers of u and 1-u taken out, "2*(1-u)*V[0,0] + V[3,0]".
///
/// Depends only on the mathematics and the order of declaration. Cut off with "…" after about
/// `longest` characters.
std::string to_text(const Fraction& fraction, const Atoms& atoms, Budget& budget,
                    std::size_t longest = 2000);

}  // namespace patchproof
