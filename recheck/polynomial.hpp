#pragma once

#include <compare>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include <recheck/meter.hpp>
#include <recheck/number.hpp>

namespace recheck {

/// A variable of polynomials; what it stands for is known to the field.
using Atom = unsigned;

struct Power {
  Atom atom = 0;
  unsigned exponent = 1;
  friend auto operator<=>(const Power&, const Power&) = default;
};

/// A product of powers of different atoms, by atom; empty is 1.
using Monomial = std::vector<Power>;

/// The lexicographic order, in which atoms with smaller numbers come first. It is kept by products,
/// so that polynomials can be divided.
struct MonomialOrder {
  bool operator()(const Monomial& a, const Monomial& b) const;
};

/// Coefficients, none of them zero; empty is 0.
using Polynomial = std::map<Monomial, Rational, MonomialOrder>;

/// Some order, to keep polynomials in sets.
struct PolynomialOrder {
  bool operator()(const Polynomial& a, const Polynomial& b) const;
};
using Polynomials = std::set<Polynomial, PolynomialOrder>;

Polynomial constant(const Rational& number);
Polynomial variable(Atom atom);
/// Adds coefficient * monomial.
void add(Polynomial& to, const Monomial& monomial, const Rational& coefficient);

Monomial product(const Monomial& a, const Monomial& b, const Meter& meter);

Polynomial sum(const Polynomial& a, const Polynomial& b, Meter& meter);
Polynomial scaled(const Polynomial& a, const Rational& factor, Meter& meter);
Polynomial product(const Polynomial& a, const Polynomial& b, Meter& meter);
/// The polynomial q with q * b = a, if there is one; b is not zero.
std::optional<Polynomial> exact_quotient(const Polynomial& a, const Polynomial& b, Meter& meter);

/// Whether it is a number, and which.
std::optional<Rational> number_in(const Polynomial& a);

/// The partial derivative in one atom, all others being constant.
Polynomial partial_derivative(const Polynomial& a, Atom atom, Meter& meter);

std::set<Atom> atoms_in(const Polynomial& a);

}  // namespace recheck
