#include "plain_polynomial.hpp"

#include <stdexcept>

namespace patchproof::differential {
namespace {

void add(PlainPolynomial& to, const PlainMonomial& monomial, const Rational& coefficient) {
  const auto [at, is_new] = to.emplace(monomial, coefficient);
  if (!is_new) at->second += coefficient;
  if (at->second == 0) to.erase(at);
}

}  // namespace

PlainPolynomial plain_number(const Rational& number) {
  PlainPolynomial result;
  add(result, {}, number);
  return result;
}

PlainPolynomial plain_variable(const std::string& name) { return {{{{name, 1}}, 1}}; }

PlainPolynomial sum(const PlainPolynomial& a, const PlainPolynomial& b) {
  PlainPolynomial result = a;
  for (const auto& [monomial, coefficient] : b) add(result, monomial, coefficient);
  return result;
}

PlainPolynomial product(const PlainPolynomial& a, const PlainPolynomial& b) {
  PlainPolynomial result;
  for (const auto& [left, p] : a)
    for (const auto& [right, q] : b) {
      PlainMonomial monomial = left;
      for (const auto& [name, exponent] : right) monomial[name] += exponent;
      add(result, monomial, p * q);
    }
  return result;
}

PlainPolynomial power(const PlainPolynomial& base, unsigned exponent) {
  PlainPolynomial result = plain_number(1);
  for (unsigned k = 0; k < exponent; ++k) result = product(result, base);
  return result;
}

PlainPolynomial derivative(const PlainPolynomial& p, const std::string& variable) {
  PlainPolynomial result;
  for (const auto& [monomial, coefficient] : p) {
    const auto power = monomial.find(variable);
    if (power == monomial.end()) continue;
    PlainMonomial lower = monomial;
    const Rational exponent = power->second;
    if (--lower[variable] == 0) lower.erase(variable);
    add(result, lower, coefficient * exponent);
  }
  return result;
}

PlainPolynomial antiderivative(const PlainPolynomial& p, const std::string& variable) {
  PlainPolynomial result;
  for (const auto& [monomial, coefficient] : p) {
    PlainMonomial higher = monomial;
    const unsigned exponent = ++higher[variable];
    add(result, higher, coefficient / exponent);
  }
  return result;
}

PlainPolynomial substituted(const PlainPolynomial& p,
                            const std::map<std::string, PlainPolynomial>& values) {
  PlainPolynomial result;
  for (const auto& [monomial, coefficient] : p) {
    PlainMonomial kept;
    PlainPolynomial term = plain_number(coefficient);
    for (const auto& [name, exponent] : monomial) {
      const auto value = values.find(name);
      if (value == values.end())
        kept[name] = exponent;
      else
        term = product(term, power(value->second, exponent));
    }
    result = sum(result, product(term, {{kept, 1}}));
  }
  return result;
}

Rational plain_value(const PlainPolynomial& p) {
  if (p.empty()) return 0;
  if (p.size() > 1 || !p.begin()->first.empty()) throw std::logic_error{"not a number"};
  return p.begin()->second;
}

}  // namespace patchproof::differential
