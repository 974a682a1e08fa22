#include <patchproof/algebra/squares.hpp>

namespace patchproof {

std::optional<Polynomial> square_root(const Polynomial& polynomial, Budget& budget) {
  if (polynomial.is_zero() || polynomial.terms().front().coefficient < 0) return std::nullopt;
  const Rational scale = polynomial.terms().front().coefficient;
  Polynomial rest = scaled(polynomial, 1 / scale);
  Polynomial root;
  // The leading term of the rest is twice the leading term of the root times the next one.
  while (!rest.is_zero()) {
    const auto& leading = rest.terms().front();
    Polynomial::Term next{Monomial{}, 1};
    if (root.is_zero()) {
      for (const auto& p : leading.monomial.powers()) {
        if (p.exponent % 2 == 1) return std::nullopt;
        next.monomial = next.monomial * Monomial{p.variable, p.exponent / 2};
      }
    } else {
      const auto& first = root.terms().front();
      const std::optional<Monomial> factor = quotient(leading.monomial, first.monomial);
      if (!factor || !(*factor < root.terms().back().monomial)) return std::nullopt;
      next = {*factor, leading.coefficient / (2 * first.coefficient)};
    }
    const Polynomial step = Polynomial::from_terms({next});
    const Polynomial twice = sum(scaled(root, 2), step, budget);
    rest = difference(rest, product(twice, step, budget), budget);
    root = sum(root, step, budget);
    if (root.terms().size() > polynomial.terms().size()) return std::nullopt;
  }
  return root;
}

bool is_definite(const Polynomial& polynomial, bool strict, Budget& budget) {
  for (const auto& term : polynomial.terms())
    if (term.monomial.total_degree() > 2) return false;
  Polynomial rest = polynomial;
  for (const Variable v : polynomial.variables()) {
    std::vector<Polynomial> parts = coefficients(rest, v);
    parts.resize(3);
    const Rational square = parts[2].constant();
    if (square < 0 || (square == 0 && !parts[1].is_zero())) return false;
    if (square == 0) continue;
    rest = difference(parts[0],
                      scaled(product(parts[1], parts[1], budget), Rational{1, 4} / square), budget);
  }
  return strict ? rest.constant() > 0 : rest.constant() >= 0;
}

}  // namespace patchproof
