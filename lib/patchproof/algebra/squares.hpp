#pragma once

#include <optional>

#include <patchproof/algebra/polynomial.hpp>

namespace patchproof {

/// q with q^2 = polynomial / c for some positive number c; empty when there is none.
std::optional<Polynomial> square_root(const Polynomial& polynomial, Budget& budget);

/// Whether a polynomial of degree two is never negative, or, strictly, always positive, for any
/// values of its variables at all; decided by completing squares. False for higher degrees.
bool is_definite(const Polynomial& polynomial, bool strict, Budget& budget);

}  // namespace patchproof
