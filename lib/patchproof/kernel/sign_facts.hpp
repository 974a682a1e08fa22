#pragma once

#include <map>
#include <vector>

#include <patchproof/algebra/linear_constraints.hpp>
#include <patchproof/algebra/sign_over_box.hpp>
#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

/// What was found out about the sign of a polynomial.
struct SignAnswer {
  enum class Kind {
    shown,      ///< it has the sign asked for
    unknown,    ///< the facts were not enough
    undecided,  ///< subdivision came to no end near the point
    negative,   ///< the wrong sign at the point
    zero,       ///< zero at the point where that is not allowed
    only_zero,  ///< the same, and nowhere of the wrong sign
    changes,    ///< "never zero": both signs occur, one of them at the point
  };
  Kind kind = Kind::unknown;
  /// The boxes that were needed; none where other facts were enough.
  Subdivision tree;
  /// Values for the variables with intervals, for all but `shown`; perhaps none.
  std::map<Variable, Rational> point;

  bool shown() const { return kind == Kind::shown; }
};

/// What is known of the signs of polynomials: inequalities, polynomials that are not zero, and
/// variables that run over an interval of rational numbers.
class SignFacts {
 public:
  struct Inequality {
    Polynomial polynomial;
    bool strict = false;  ///< polynomial > 0 instead of >= 0
  };
  using Interval = patchproof::Interval;

  void add_inequality(const Polynomial& polynomial, bool strict);
  void add_not_zero(const Polynomial& polynomial);
  void add_interval(Variable variable, const Interval& interval);

  const std::vector<Inequality>& inequalities() const { return inequalities_; }
  const std::vector<Polynomial>& not_zero() const { return not_zero_; }

  /// Whether the polynomial is nowhere negative, or, strictly, positive everywhere.
  ///
  /// Methods: constants; sums of products of what is known not to be negative; squares; definite
  /// polynomials of degree two; Fourier-Motzkin for linear ones; factors of known sign; subdivision
  /// over the box of the variables with intervals, where the coefficients may hold other variables.
  SignAnswer sign(const Polynomial& polynomial, bool strict, Budget& budget) const;

  /// Whether the polynomial vanishes nowhere: it has one strict sign.
  SignAnswer apart_from_zero(const Polynomial& polynomial, Budget& budget) const;

  /// The same as a word: `false` means only that the facts were not enough.
  bool never_zero(const Polynomial& polynomial, Budget& budget) const;
  bool never_negative(const Polynomial& polynomial, Budget& budget) const;
  bool always_positive(const Polynomial& polynomial, Budget& budget) const;

  /// Whether the linear inequalities have no common solution, or a fact is absurd by itself.
  bool contradictory(Budget& budget) const;

 private:
  bool impossible(const Polynomial& polynomial, LinearConstraint::Kind kind, Budget& budget) const;
  bool is_sum_of_signed(const Polynomial& polynomial, bool strict, Budget& budget) const;
  Polynomial without_known_factors(const Polynomial& polynomial, bool strict, Budget& budget) const;
  SignAnswer sign_by_boxes(const Polynomial& polynomial, bool strict, Budget& budget) const;
  SignAnswer sign_with_symbols(const Polynomial& polynomial, const Box& box, bool strict,
                               Budget& budget) const;
  bool symbolic_sign(const Polynomial& polynomial, const Box& box, unsigned cuts, bool strict,
                     SignAnswer& answer, Budget& budget) const;
  /// The variables of the polynomial that run over an interval of numbers, declared or assumed.
  Box box_of(const Polynomial& polynomial) const;

  std::vector<Inequality> inequalities_;
  std::vector<Polynomial> not_zero_;
  std::map<Variable, Interval> intervals_;
};

/// The polynomial as a linear constraint; empty when it is not linear.
std::optional<LinearConstraint> linear_constraint(const Polynomial& polynomial,
                                                  LinearConstraint::Kind kind);

}  // namespace patchproof
