#include <patchproof/algebra/odd_part.hpp>

namespace patchproof {

namespace {

// a modulo b, both in the one variable; b is not zero.
Polynomial remainder(const Polynomial& a, const Polynomial& b, Variable v, Budget& budget) {
  Polynomial rest = a;
  const unsigned degree = b.degree(v);
  const Rational leading = coefficients(b, v).back().constant();
  while (!rest.is_zero() && rest.degree(v) >= degree) {
    const std::vector<Polynomial> parts = coefficients(rest, v);
    const Rational factor = parts.back().constant() / leading;
    const unsigned shift = rest.degree(v) - degree;
    const Polynomial power =
        Polynomial::from_terms({{shift == 0 ? Monomial{} : Monomial{v, shift}, factor}});
    rest = difference(rest, product(power, b, budget), budget);
  }
  return rest;
}

// The greatest common divisor, with whole coprime coefficients.
Polynomial common_divisor(Polynomial a, Polynomial b, Variable v, Budget& budget) {
  while (!b.is_zero()) {
    Polynomial rest = remainder(a, b, v, budget);
    a = std::move(b);
    b = rest.is_zero() ? rest : scaled(rest, 1 / content(rest));
  }
  return scaled(a, 1 / content(a));
}

Polynomial exact_quotient(const Polynomial& a, const Polynomial& b, Budget& budget) {
  return quotient(a, b, budget).value();
}

}  // namespace

Polynomial odd_part(const Polynomial& polynomial, Variable variable, Budget& budget) {
  if (polynomial.is_constant()) return polynomial;
  Polynomial result{Rational{1}};
  // Yun's algorithm: in round k the divisor found is the product of the factors of multiplicity k.
  const Polynomial slope = derivative(polynomial, variable);
  const Polynomial common = common_divisor(polynomial, slope, variable, budget);
  Polynomial rest = exact_quotient(polynomial, common, budget);
  Polynomial other = exact_quotient(slope, common, budget);
  for (unsigned multiplicity = 1; !rest.is_constant(); ++multiplicity) {
    const Polynomial gap = difference(other, derivative(rest, variable), budget);
    const Polynomial factor = common_divisor(rest, gap, variable, budget);
    if (multiplicity % 2 == 1) result = product(result, factor, budget);
    rest = exact_quotient(rest, factor, budget);
    if (!gap.is_zero())
      other = exact_quotient(gap, factor, budget);
    else
      other = Polynomial{};
  }
  // Beyond all zeros both have the sign of their leading coefficients.
  const auto leading = [&](const Polynomial& p) {
    return coefficients(p, variable).back().constant();
  };
  return (leading(polynomial) > 0) == (leading(result) > 0) ? result : scaled(result, -1);
}

}  // namespace patchproof
