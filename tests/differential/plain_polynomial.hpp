#pragma once

#include <map>
#include <string>

#include <patchproof/algebra/number.hpp>

namespace patchproof::differential {

/// A product of powers of variables: name -> exponent, none of them 0.
using PlainMonomial = std::map<std::string, unsigned>;

/// A polynomial as slow and plain as can be: monomial -> coefficient, none of them 0.
///
/// It shares no code with the polynomials of the library, so that their faults are not its own.
using PlainPolynomial = std::map<PlainMonomial, Rational>;

PlainPolynomial plain_number(const Rational& number);
PlainPolynomial plain_variable(const std::string& name);
PlainPolynomial sum(const PlainPolynomial& a, const PlainPolynomial& b);
PlainPolynomial product(const PlainPolynomial& a, const PlainPolynomial& b);
PlainPolynomial power(const PlainPolynomial& base, unsigned exponent);
PlainPolynomial derivative(const PlainPolynomial& p, const std::string& variable);
PlainPolynomial antiderivative(const PlainPolynomial& p, const std::string& variable);

/// With polynomials in place of variables, all at once.
PlainPolynomial substituted(const PlainPolynomial& p,
                            const std::map<std::string, PlainPolynomial>& values);

/// The number a polynomial without variables is.
/// @throws std::logic_error when it has some.
Rational plain_value(const PlainPolynomial& p);

}  // namespace patchproof::differential
