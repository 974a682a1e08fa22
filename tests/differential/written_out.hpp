#pragma once

#include "expression.hpp"
#include "plain_polynomial.hpp"

namespace patchproof::differential {

/// A number as a literal, perhaps with a sign.
Node rational(const Rational& value);

/// A polynomial as a sum of products of numbers and powers.
Node written_out(const PlainPolynomial& p);

}  // namespace patchproof::differential
