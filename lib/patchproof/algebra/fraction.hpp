#pragma once

#include <map>
#include <vector>

#include <patchproof/algebra/polynomial.hpp>

namespace patchproof {

/// A polynomial divided by a product of polynomials.
///
/// Nothing says that the denominator is not zero somewhere: whoever divides has to remember that
/// condition. Common factors may be cancelled, so the denominator alone does not tell it.
class Fraction {
 public:
  /// Primitive polynomials with positive leading coefficient -> exponent >= 1.
  using Factors = std::map<Polynomial, unsigned>;

  Fraction() = default;
  Fraction(const Rational& number) : numerator_{number} {}           // NOLINT: embedding
  Fraction(Polynomial polynomial) : numerator_{std::move(polynomial)} {}  // NOLINT: embedding
  /// numerator / product of factors, with factors cancelled where they divide the numerator.
  Fraction(Polynomial numerator, const Factors& denominator, Budget& budget);

  const Polynomial& numerator() const { return numerator_; }
  const Factors& denominator() const { return denominator_; }
  bool is_zero() const { return numerator_.is_zero(); }
  bool is_polynomial() const { return denominator_.empty(); }

  /// A total order, without mathematical meaning, for use as a key.
  friend bool operator<(const Fraction& a, const Fraction& b);

 private:
  Polynomial numerator_;
  Factors denominator_;
};

Fraction sum(const Fraction& a, const Fraction& b, Budget& budget);
Fraction difference(const Fraction& a, const Fraction& b, Budget& budget);
Fraction product(const Fraction& a, const Fraction& b, Budget& budget);

/// @throws std::domain_error when b is identically zero.
Fraction quotient(const Fraction& a, const Fraction& b, Budget& budget);

/// Any whole exponent. @throws std::domain_error for a negative power of zero.
Fraction power(const Fraction& a, long exponent, Budget& budget);

/// All variables named in `images` replaced at once.
/// @throws std::domain_error when a denominator becomes identically zero.
Fraction substituted(const Fraction& fraction, const std::map<Variable, Fraction>& images,
                     Budget& budget);

/// The variables of numerator and denominator.
std::set<Variable> variables(const Fraction& fraction);

/// The product of the factors with their exponents.
Polynomial expanded(const Fraction::Factors& factors, Budget& budget);

/// The polynomial divided by its content, with positive leading coefficient; `scale` times the
/// result is the polynomial.
struct Primitive {
  Polynomial polynomial;
  Rational scale;
};
Primitive primitive(const Polynomial& polynomial);

}  // namespace patchproof
