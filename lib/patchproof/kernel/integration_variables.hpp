#pragma once

#include <patchproof/kernel/integral.hpp>

namespace patchproof {

/// Whether the value of the polynomial changes with a variable of the integral. Within other
/// integrals these variables are bound anew, and mean something else.
bool depends(const Polynomial& polynomial, const IntegrationRanges& ranges, const Atoms& atoms);

/// All variables of the polynomial and of the arguments of its atoms, at any depth, those bound in
/// integrals included.
std::set<Variable> all_variables_within(const Polynomial& polynomial, const Atoms& atoms);

/// The variables of integrals on which the value of the polynomial depends: those that are not
/// bound within it.
std::set<Variable> free_running(const Polynomial& polynomial, const Atoms& atoms);

/// Numerator and factors of the denominator.
std::vector<Polynomial> parts_of(const Fraction& fraction);

/// Checks that the factors, all of which depend on variables of an integral, are defined and
/// continuous everywhere: no roots, no divisions, no integrals in them.
/// @throws OutsideTheory
void require_plain(const Monomial& monomial, const Atoms& atoms);

}  // namespace patchproof
