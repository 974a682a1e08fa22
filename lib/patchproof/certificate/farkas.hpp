#pragma once

#include <optional>
#include <vector>

#include <patchproof/algebra/polynomial.hpp>

namespace patchproof {

/// A polynomial that is known not to be negative, or to be positive.
struct SignedPolynomial {
  Polynomial polynomial;
  bool strict = false;
};

/// Factors, none of them negative, and a number that is not negative, with
/// goal = sum of factors * facts + number; strict: the number or the factor of a strict fact is
/// positive. Empty when none were found.
///
/// Polynomials that are not linear are left out. Source: Schrijver, Theory of Linear and Integer
/// Programming, 7.3 (Farkas' lemma) and 12.2 (Fourier-Motzkin elimination).
std::optional<std::vector<Rational>> farkas_factors(const std::vector<SignedPolynomial>& facts,
                                                    const SignedPolynomial& goal, Budget& budget);

}  // namespace patchproof
