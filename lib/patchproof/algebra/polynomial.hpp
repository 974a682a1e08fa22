#pragma once

#include <boost/container/small_vector.hpp>
#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/algebra/number.hpp>

namespace patchproof {

/// Names a variable of a polynomial; what it stands for is known to whoever made it.
using Variable = unsigned;

/// A product of powers of variables, x^2*y. The empty product is 1.
///
/// Ordered lexicographically with x0 > x1 > …, an order that multiplication preserves.
class Monomial {
 public:
  struct Power {
    Variable variable;
    unsigned exponent;
    friend bool operator==(const Power&, const Power&) = default;
  };

  Monomial() = default;
  explicit Monomial(Variable variable, unsigned exponent = 1);

  /// Sorted by variable, exponents at least 1.
  const auto& powers() const { return powers_; }
  bool is_one() const { return powers_.empty(); }
  unsigned exponent(Variable variable) const;
  unsigned total_degree() const;

  /// The monomial without the powers of the variable.
  Monomial without(Variable variable) const;

  friend Monomial operator*(const Monomial& a, const Monomial& b);
  /// a / b when b divides a.
  friend std::optional<Monomial> quotient(const Monomial& a, const Monomial& b);
  friend bool operator==(const Monomial& a, const Monomial& b) { return a.powers_ == b.powers_; }
  friend std::strong_ordering operator<=>(const Monomial& a, const Monomial& b);

 private:
  boost::container::small_vector<Power, 4> powers_;
};

std::size_t hash_value(const Monomial& monomial);

/// A polynomial over the rational numbers in any number of variables, in expanded normal form:
/// two polynomials are equal exactly when their terms are.
class Polynomial {
 public:
  struct Term {
    Monomial monomial;
    Rational coefficient;
    friend bool operator==(const Term&, const Term&) = default;
  };

  Polynomial() = default;
  Polynomial(const Rational& constant);  // NOLINT: a number is a polynomial
  static Polynomial variable(Variable variable);
  /// Sums up the terms given in any order.
  static Polynomial from_terms(std::vector<Term> terms);

  /// Greatest monomial first; no zero coefficients.
  const std::vector<Term>& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  bool is_constant() const { return terms_.empty() || (terms_.size() == 1 && is_constant_term()); }
  /// The coefficient of the monomial 1.
  Rational constant() const;
  std::set<Variable> variables() const;
  unsigned degree(Variable variable) const;

  friend bool operator==(const Polynomial& a, const Polynomial& b) = default;
  /// A total order, without mathematical meaning, for use as a key.
  friend bool operator<(const Polynomial& a, const Polynomial& b);

 private:
  bool is_constant_term() const { return terms_.front().monomial.is_one(); }
  std::vector<Term> terms_;
};

Polynomial sum(const Polynomial& a, const Polynomial& b, Budget& budget);
Polynomial difference(const Polynomial& a, const Polynomial& b, Budget& budget);
Polynomial product(const Polynomial& a, const Polynomial& b, Budget& budget);
Polynomial power(const Polynomial& base, unsigned exponent, Budget& budget);
Polynomial scaled(const Polynomial& polynomial, const Rational& factor);

/// The partial derivative in the variable, all others held fixed.
Polynomial derivative(const Polynomial& polynomial, Variable variable);

/// a / b when b divides a exactly; empty otherwise.
/// @throws std::domain_error when b is zero.
std::optional<Polynomial> quotient(const Polynomial& a, const Polynomial& b, Budget& budget);

/// All variables named in `images` replaced at once; the others stay.
Polynomial substituted(const Polynomial& polynomial, const std::map<Variable, Polynomial>& images,
                       Budget& budget);

/// The coefficients of the powers of one variable: entry k belongs to variable^k.
std::vector<Polynomial> coefficients(const Polynomial& polynomial, Variable variable);

/// How many steps of a budget one multiplication of these numbers counts: work grows with their
/// length.
std::uint64_t coefficient_cost(const Rational& a, const Rational& b);

/// The positive rational c for which polynomial/c has whole, coprime coefficients; 1 for zero.
Rational content(const Polynomial& polynomial);

}  // namespace patchproof

template <>
struct std::hash<patchproof::Monomial> {
  std::size_t operator()(const patchproof::Monomial& monomial) const {
    return patchproof::hash_value(monomial);
  }
};
