#pragma once

#include <map>
#include <vector>

#include <patchproof/algebra/linear_constraints.hpp>
#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

/// What is known of the signs of polynomials: inequalities, polynomials that are not zero, and
/// variables that run over an interval of rational numbers.
class SignFacts {
 public:
  struct Inequality {
    Polynomial polynomial;
    bool strict = false;  ///< polynomial > 0 instead of >= 0
  };
  struct Interval {
    Rational low;
    Rational high;
  };

  void add_inequality(const Polynomial& polynomial, bool strict);
  void add_not_zero(const Polynomial& polynomial);
  void add_interval(Variable variable, const Interval& interval);

  const std::vector<Inequality>& inequalities() const { return inequalities_; }
  const std::vector<Polynomial>& not_zero() const { return not_zero_; }

  /// Whether the facts show it; `false` means only that they were not enough.
  ///
  /// Methods: constants; factors known not to vanish; sums of even powers; Fourier-Motzkin for linear polynomials;
  /// positive terms; equal signs of all Bernstein coefficients over a box (Farin, ch. 5: convex hull property).
  bool never_zero(const Polynomial& polynomial, Budget& budget) const;
  bool never_negative(const Polynomial& polynomial, Budget& budget) const;
  bool always_positive(const Polynomial& polynomial, Budget& budget) const;

  /// Whether the linear inequalities have no common solution, or a fact is absurd by itself.
  bool contradictory(Budget& budget) const;

 private:
  bool impossible(const Polynomial& polynomial, LinearConstraint::Kind kind, Budget& budget) const;
  /// Positive coefficients and positive variables (not negative ones, when not strict).
  bool positive_by_terms(const Polynomial& polynomial, bool strict, Budget& budget) const;
  /// Variables without an interval stay in the Bernstein coefficients, whose signs then are to be
  /// shown by the facts.
  bool bernstein_positive(const Polynomial& polynomial, bool strict, Budget& budget) const;

  std::vector<Inequality> inequalities_;
  std::vector<Polynomial> not_zero_;
  std::map<Variable, Interval> intervals_;
};

/// The polynomial as a linear constraint; empty when it is not linear.
std::optional<LinearConstraint> linear_constraint(const Polynomial& polynomial,
                                                  LinearConstraint::Kind kind);

}  // namespace patchproof
