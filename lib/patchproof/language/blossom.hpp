#pragma once

#include <patchproof/language/construction.hpp>
#include <patchproof/language/knots.hpp>

namespace patchproof {

/// Sums, differences and ratios of scalars as terms; numbers are folded and the number 0 left out.
class KnotArithmetic {
 public:
  KnotArithmetic(Construction& construct, const Span& span) : construct_{construct}, span_{span} {}

  /// A number as a term.
  Term number(const Rational& value) const { return number_term(value, span_); }
  /// a + b
  Term sum(const Term& a, const Term& b);
  /// a - b; 0 for knots that are written alike.
  Term difference(const Term& a, const Term& b);
  /// a * b
  Term product(const Term& a, const Term& b);
  /// a / b. A divisor that is no number stays, also under 0: it is a condition.
  Term ratio(const Term& a, const Term& b);
  /// factors[0]*terms[0] + …; the terms are scalars or points.
  Term combination(const std::vector<Term>& factors, const std::vector<Term>& terms);

 private:
  Construction& construct_;
  Span span_;
};

/// Factors of the control points span-degree, …, span in the value f(arguments) of the blossom of
/// the piece of a spline over [knots[span], knots[span+1]]: de Boor's algorithm with a different
/// parameter at each level.
/// Source: Farin, Curves and Surfaces for CAGD, ch. 8; Ramshaw, Blossoms are polar forms.
std::vector<Term> blossom(const Knots& knots, int degree, int span,
                          const std::vector<Term>& arguments, Workshop& workshop,
                          Construction& construct, const Span& where);

}  // namespace patchproof
