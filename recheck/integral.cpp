#include <recheck/calculus.hpp>

namespace recheck {

namespace {

bool contains(const Quotient& a, Atom atom, const Field& field) {
  return atoms_within(a, field).contains(atom);
}

}  // namespace

Quotient integral(const Quotient& a, Atom over, const Quotient& lower, const Quotient& upper,
                  Field& field) {
  for (const auto& [factor, exponent] : a.denominator)
    if (contains(as_quotient(factor), over, field))
      throw Unsupported{"the integral of a quotient whose divisor depends on its variable"};
  // Coefficients of the powers of the variable.
  std::map<unsigned, Polynomial> coefficients;
  for (const auto& [monomial, coefficient] : a.numerator) {
    unsigned exponent = 0;
    Monomial rest;
    for (const Power& power : monomial) {
      if (power.atom == over) {
        exponent = power.exponent;
        continue;
      }
      if (!field.meaning(power.atom).arguments.empty() &&
          contains(of_atom(power.atom), over, field))
        throw Unsupported{"the integral of an unknown function"};
      rest.push_back(power);
    }
    add(coefficients[exponent], rest, coefficient);
  }
  Quotient result;
  for (const auto& [exponent, coefficient] : coefficients) {
    const Quotient ends =
        field.difference(field.power(upper, exponent + 1), field.power(lower, exponent + 1));
    const Quotient part = field.product(as_quotient(coefficient), ends);
    result = field.sum(result, field.multiple(part, Rational{1, exponent + 1}));
  }
  return field.product(result, Quotient{constant(1), a.denominator});
}

}  // namespace recheck
