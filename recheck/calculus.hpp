#pragma once

#include <recheck/field.hpp>

namespace recheck {

using Images = std::map<Atom, Quotient>;

/// All atoms at once replaced by what they are mapped to, also in the arguments of functions. The
/// divisors of the result are those of the images and the images of the divisors.
/// @throws Rejection when a divisor becomes zero
Quotient substituted(const Quotient& a, const Images& images, Field& field);

/// The numerators of the replaced divisors, without those that are numbers.
/// @throws Rejection when one becomes zero
Polynomials substituted_divisors(const Polynomials& divisors, const Images& images, Field& field);

/// The derivative in a coordinate or slot, by the chain rule also through the arguments of
/// functions.
/// @throws Rejection when a function need not have the derivative
Quotient derivative(const Quotient& a, Atom in, Field& field);

/// The integral of a polynomial in the atom from `lower` to `upper`.
/// @throws Unsupported when a divisor or the argument of a function contains the atom
Quotient integral(const Quotient& a, Atom over, const Quotient& lower, const Quotient& upper,
                  Field& field);

}  // namespace recheck
