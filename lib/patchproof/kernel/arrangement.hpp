#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <patchproof/kernel/atoms.hpp>

namespace patchproof {

/// The order in which a person writes a polynomial: collected by the unknowns in the order of
/// their declaration, powers of u and 1-u taken out of the coefficients.
///
/// Depends only on the mathematics, the order of declaration and, where these say nothing, on the
/// names; never on the numbers of the variables.
class Arrangement {
 public:
  using Name = std::function<std::string(Variable)>;

  /// `name` must outlive the arrangement's use.
  Arrangement(const Atoms& atoms, Budget& budget, Name name)
      : atoms_{atoms}, budget_{budget}, name_{std::move(name)} {}

  /// A product of unknowns and what it is multiplied with, a polynomial in the parameters.
  struct Group {
    Monomial unknowns;
    Polynomial coefficient;
  };
  /// sign * number * product of factors * rest.
  struct Factored {
    bool negative = false;
    Rational number = 1;
    /// u, 1-u and their exponents, in order.
    std::vector<std::pair<Polynomial, unsigned>> factors;
    /// With the greatest common divisor 1 of its coefficients and a positive first one.
    Polynomial rest;
  };

  std::vector<Group> groups(const Polynomial& polynomial) const;
  Factored factored(const Polynomial& coefficient) const;
  /// Earlier variables and higher powers first.
  std::vector<Polynomial::Term> terms(const Polynomial& polynomial) const;
  std::vector<Monomial::Power> powers(const Monomial& monomial) const;

 private:
  bool earlier(Variable a, Variable b) const;
  bool before(const Monomial& a, const Monomial& b) const;

  const Atoms& atoms_;
  Budget& budget_;
  Name name_;
};

}  // namespace patchproof
