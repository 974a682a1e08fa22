#pragma once

#include <ginac/ginac.h>

#include <patchproof/symbolic/atoms.hpp>

namespace patchproof::symbolic {

/// The highest order of a root of unity that is computed with.
inline constexpr long highest_order = 1200;

/// The atom exp(i*pi/divisor) as a root of unity.
struct RootOfUnity {
  unsigned atom = 0;
  long divisor = 1;
};

/// The order of the field in which powers of this root of unity and of i are compared.
long field_order(long divisor);

/// The polynomial with the powers of one root of unity, i, and those square roots of primes that
/// lie in the same cyclotomic field, written in a basis of that field: it is zero exactly when all
/// its coefficients are.
///
/// `field_order(root.divisor)` is at most `highest_order`.
/// Source: Gauss sums with their sign, Ireland & Rosen, A Classical Introduction to Modern Number
/// Theory, 6.4.
GiNaC::ex in_cyclotomic_basis(const GiNaC::ex& polynomial, const RootOfUnity& root, Atoms& atoms);

}  // namespace patchproof::symbolic
