#include <stdexcept>

#include <patchproof/algebra/polynomial.hpp>

namespace patchproof {

std::optional<Polynomial> quotient(const Polynomial& a, const Polynomial& b, Budget& budget) {
  if (b.is_zero()) throw std::domain_error{"division by the zero polynomial"};
  // A map keeps the remainder sorted while leading terms are taken off one by one.
  std::map<Monomial, Rational, std::greater<>> rest;
  for (const auto& term : a.terms()) rest.emplace(term.monomial, term.coefficient);
  const auto& leading = b.terms().front();
  std::vector<Polynomial::Term> terms;
  while (!rest.empty()) {
    const auto first = rest.begin();
    const std::optional<Monomial> monomial = quotient(first->first, leading.monomial);
    if (!monomial) return std::nullopt;
    const Rational coefficient = first->second / leading.coefficient;
    for (const auto& term : b.terms()) {
      budget.spend(coefficient_cost(coefficient, term.coefficient));
      const Monomial product = *monomial * term.monomial;
      const auto place = rest.try_emplace(product, Rational{0}).first;
      place->second -= coefficient * term.coefficient;
      if (place->second == 0) rest.erase(place);
    }
    terms.push_back({*monomial, coefficient});
    budget.require_terms(terms.size() + rest.size());
  }
  return Polynomial::from_terms(std::move(terms));
}

Polynomial substituted(const Polynomial& polynomial, const std::map<Variable, Polynomial>& images,
                       Budget& budget) {
  std::map<std::pair<Variable, unsigned>, Polynomial> powers;
  const auto image_power = [&](Variable variable, unsigned exponent) -> const Polynomial& {
    const auto key = std::pair{variable, exponent};
    const auto found = powers.find(key);
    if (found != powers.end()) return found->second;
    return powers.emplace(key, power(images.at(variable), exponent, budget)).first->second;
  };
  // Terms that share the part to be replaced are replaced together.
  std::map<Monomial, std::vector<Polynomial::Term>> groups;
  for (const auto& term : polynomial.terms()) {
    Monomial kept;
    Monomial replaced;
    for (const auto& p : term.monomial.powers()) {
      Monomial& part = images.contains(p.variable) ? replaced : kept;
      part = part * Monomial{p.variable, p.exponent};
    }
    groups[replaced].push_back({kept, term.coefficient});
  }
  Polynomial result;
  for (auto& [replaced, rest] : groups) {
    Polynomial value = Polynomial::from_terms(std::move(rest));
    for (const auto& p : replaced.powers())
      value = product(value, image_power(p.variable, p.exponent), budget);
    result = sum(result, value, budget);
  }
  return result;
}

std::vector<Polynomial> coefficients(const Polynomial& polynomial, Variable variable) {
  std::vector<std::vector<Polynomial::Term>> parts(polynomial.degree(variable) + 1);
  for (const auto& term : polynomial.terms())
    parts[term.monomial.exponent(variable)].push_back(
        {term.monomial.without(variable), term.coefficient});
  std::vector<Polynomial> result;
  for (auto& part : parts) result.push_back(Polynomial::from_terms(std::move(part)));
  return result;
}

Rational content(const Polynomial& polynomial) {
  if (polynomial.is_zero()) return 1;
  Integer numerators = 0;
  Integer denominators = 1;
  for (const auto& term : polynomial.terms()) {
    numerators = gcd(numerators, Integer{numerator(term.coefficient)});
    denominators = lcm(denominators, Integer{denominator(term.coefficient)});
  }
  return Rational{abs(numerators), denominators};
}

}  // namespace patchproof
