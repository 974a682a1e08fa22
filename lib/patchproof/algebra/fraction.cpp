#include <patchproof/algebra/fraction.hpp>

#include <algorithm>
#include <stdexcept>

namespace patchproof {

namespace {

using Factors = Fraction::Factors;

// Sets `factors` to their least common multiple with `others`.
Factors least_common_multiple(Factors factors, const Factors& others) {
  for (const auto& [factor, exponent] : others) {
    unsigned& mine = factors[factor];
    mine = std::max(mine, exponent);
  }
  return factors;
}

// whole / part, where part divides whole factor by factor.
Polynomial cofactor(const Factors& whole, const Factors& part, Budget& budget) {
  Polynomial result{Rational{1}};
  for (const auto& [factor, exponent] : whole) {
    const auto found = part.find(factor);
    const unsigned rest = exponent - (found == part.end() ? 0 : found->second);
    if (rest > 0) result = product(result, power(factor, rest, budget), budget);
  }
  return result;
}

}  // namespace

Primitive primitive(const Polynomial& polynomial) {
  if (polynomial.is_zero()) return {polynomial, 1};
  Rational scale = content(polynomial);
  if (polynomial.terms().front().coefficient < 0) scale = -scale;
  return {scaled(polynomial, 1 / scale), scale};
}

Fraction::Fraction(Polynomial numerator, const Factors& denominator, Budget& budget)
    : numerator_{std::move(numerator)} {
  if (numerator_.is_zero()) return;
  for (const auto& [factor, exponent] : denominator) {
    unsigned rest = exponent;
    while (rest > 0) {
      std::optional<Polynomial> shorter = quotient(numerator_, factor, budget);
      if (!shorter) break;
      numerator_ = std::move(*shorter);
      --rest;
    }
    if (rest > 0) denominator_.emplace(factor, rest);
  }
}

bool operator<(const Fraction& a, const Fraction& b) {
  if (!(a.numerator_ == b.numerator_)) return a.numerator_ < b.numerator_;
  return std::lexicographical_compare(a.denominator_.begin(), a.denominator_.end(),
                                      b.denominator_.begin(), b.denominator_.end());
}

Fraction sum(const Fraction& a, const Fraction& b, Budget& budget) {
  if (a.is_polynomial() && b.is_polynomial()) return sum(a.numerator(), b.numerator(), budget);
  const Factors common = least_common_multiple(a.denominator(), b.denominator());
  return {sum(product(a.numerator(), cofactor(common, a.denominator(), budget), budget),
              product(b.numerator(), cofactor(common, b.denominator(), budget), budget), budget),
          common, budget};
}

Fraction difference(const Fraction& a, const Fraction& b, Budget& budget) {
  return sum(a, product(b, Fraction{Rational{-1}}, budget), budget);
}

Fraction product(const Fraction& a, const Fraction& b, Budget& budget) {
  if (a.is_polynomial() && b.is_polynomial()) return product(a.numerator(), b.numerator(), budget);
  Factors factors = a.denominator();
  for (const auto& [factor, exponent] : b.denominator()) factors[factor] += exponent;
  return {product(a.numerator(), b.numerator(), budget), factors, budget};
}

Fraction quotient(const Fraction& a, const Fraction& b, Budget& budget) {
  if (b.is_zero()) throw std::domain_error{"division by zero"};
  const Primitive divisor = primitive(b.numerator());
  Factors factors = a.denominator();
  if (!divisor.polynomial.is_constant()) factors[divisor.polynomial] += 1;
  const Polynomial numerator =
      scaled(product(a.numerator(), expanded(b.denominator(), budget), budget), 1 / divisor.scale);
  return {numerator, factors, budget};
}

Fraction power(const Fraction& a, long exponent, Budget& budget) {
  if (exponent < 0) return quotient(Rational{1}, power(a, -exponent, budget), budget);
  Factors factors;
  if (exponent > 0)
    for (const auto& [factor, count] : a.denominator())
      factors[factor] = count * static_cast<unsigned>(exponent);
  return {power(a.numerator(), static_cast<unsigned>(exponent), budget), factors, budget};
}

namespace {

Fraction polynomial_at(const Polynomial& polynomial, const std::map<Variable, Fraction>& images,
                       Budget& budget) {
  std::map<Variable, Polynomial> plain;
  std::map<Variable, const Fraction*> rational;
  for (const Variable variable : polynomial.variables()) {
    const auto found = images.find(variable);
    if (found == images.end()) continue;
    if (found->second.is_polynomial())
      plain.emplace(variable, found->second.numerator());
    else
      rational.emplace(variable, &found->second);
  }
  if (rational.empty())
    return plain.empty() ? Fraction{polynomial} : Fraction{substituted(polynomial, plain, budget)};
  std::map<std::pair<Variable, unsigned>, Fraction> powers;
  std::map<Monomial, std::vector<Polynomial::Term>> groups;
  for (const auto& term : polynomial.terms()) {
    Monomial kept;
    Monomial replaced;
    for (const auto& p : term.monomial.powers()) {
      Monomial& part = rational.contains(p.variable) ? replaced : kept;
      part = part * Monomial{p.variable, p.exponent};
    }
    groups[replaced].push_back({kept, term.coefficient});
  }
  Fraction result;
  for (auto& [replaced, rest] : groups) {
    Fraction value{substituted(Polynomial::from_terms(std::move(rest)), plain, budget)};
    for (const auto& p : replaced.powers()) {
      auto [place, fresh] = powers.try_emplace({p.variable, p.exponent});
      if (fresh) place->second = power(*rational.at(p.variable), p.exponent, budget);
      value = product(value, place->second, budget);
    }
    result = sum(result, value, budget);
  }
  return result;
}

}  // namespace

Fraction substituted(const Fraction& fraction, const std::map<Variable, Fraction>& images,
                     Budget& budget) {
  Fraction result = polynomial_at(fraction.numerator(), images, budget);
  for (const auto& [factor, exponent] : fraction.denominator())
    result = quotient(
        result, power(polynomial_at(factor, images, budget), static_cast<long>(exponent), budget),
        budget);
  return result;
}

std::set<Variable> variables(const Fraction& fraction) {
  std::set<Variable> result = fraction.numerator().variables();
  for (const auto& [factor, exponent] : fraction.denominator()) result.merge(factor.variables());
  return result;
}

Polynomial expanded(const Factors& factors, Budget& budget) {
  Polynomial result{Rational{1}};
  for (const auto& [factor, exponent] : factors)
    result = product(result, power(factor, exponent, budget), budget);
  return result;
}

}  // namespace patchproof
