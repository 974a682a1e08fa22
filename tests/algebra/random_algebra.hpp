#pragma once

#include <random>
#include <string>

#include <patchproof/algebra/fraction.hpp>

/// Small random polynomials and fractions in x0, x1, x2, the same in every run of a seed, and
/// evaluation at rational points that shares no code with the library.
namespace patchproof {

using Point = std::map<Variable, Rational>;

inline int random_small(std::mt19937& random, int largest) {
  return static_cast<int>(random() % (2 * static_cast<unsigned>(largest) + 1)) - largest;
}

inline Rational random_rational(std::mt19937& random) {
  return Rational{random_small(random, 7), 1 + static_cast<int>(random() % 4)};
}

inline Polynomial random_polynomial(std::mt19937& random, unsigned variables = 3,
                                    unsigned degree = 3, unsigned terms = 5) {
  std::vector<Polynomial::Term> result;
  for (unsigned k = 0; k < terms; ++k) {
    Monomial monomial;
    for (unsigned d = random() % (degree + 1); d > 0; --d)
      monomial = monomial * Monomial{static_cast<Variable>(random() % variables)};
    result.push_back({monomial, random_rational(random)});
  }
  return Polynomial::from_terms(std::move(result));
}

inline Polynomial random_nonzero(std::mt19937& random, unsigned variables = 3, unsigned degree = 2,
                                 unsigned terms = 3) {
  for (;;) {
    Polynomial result = random_polynomial(random, variables, degree, terms);
    if (!result.is_zero()) return result;
  }
}

inline Point random_point(std::mt19937& random, unsigned variables = 3) {
  Point result;
  for (Variable v = 0; v < variables; ++v)
    result[v] = Rational{random_small(random, 40), 7 + static_cast<int>(random() % 5)};
  return result;
}

inline Rational value_at(const Polynomial& polynomial, const Point& point) {
  Rational total = 0;
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    Rational product = coefficient;
    for (const auto& [variable, exponent] : monomial.powers())
      for (unsigned k = 0; k < exponent; ++k) product *= point.at(variable);
    total += product;
  }
  return total;
}

/// The value; zero denominators are the caller's to avoid.
inline Rational denominator_at(const Fraction& fraction, const Point& point) {
  Rational below = 1;
  for (const auto& [factor, exponent] : fraction.denominator())
    for (unsigned k = 0; k < exponent; ++k) below *= value_at(factor, point);
  return below;
}

inline Rational value_at(const Fraction& fraction, const Point& point) {
  return value_at(fraction.numerator(), point) / denominator_at(fraction, point);
}

/// For the messages of failing tests.
inline std::string words(const Polynomial& polynomial) {
  std::string result;
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    result += (result.empty() ? "" : " + ") + to_text(coefficient);
    for (const auto& [variable, exponent] : monomial.powers())
      result += "*x" + std::to_string(variable) + "^" + std::to_string(exponent);
  }
  return result.empty() ? "0" : result;
}

inline std::string words(const Fraction& fraction) {
  std::string result = "(" + words(fraction.numerator()) + ")";
  for (const auto& [factor, exponent] : fraction.denominator())
    result += " / (" + words(factor) + ")^" + std::to_string(exponent);
  return result;
}

}  // namespace patchproof
