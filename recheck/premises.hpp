#pragma once

#include <recheck/calculus.hpp>
#include <recheck/evaluation.hpp>
#include <recheck/interval.hpp>

namespace recheck {

/// A scalar that is not negative, or positive; or one that is zero.
struct Fact {
  Quotient scalar;
  bool strict = false;
  /// Divisors in it.
  Polynomials divisors;
};

/// Left side minus right side of a statement, by components.
Value difference_of(const Statement& statement, Evaluator& evaluator);

/// Greater side minus smaller side of an order, and whether they differ.
Fact order_fact(const Statement& statement, Evaluator& evaluator);

/// Ranges with ends that are numbers, or lie between numbers: the box of the parameters.
Box box_of(const std::vector<Range>& ranges, Evaluator& evaluator);

/// What the hypotheses and ranges of a sequent give to its proofs.
class Premises {
 public:
  Premises(const Sequent& sequent, const Certificate& certificate, Evaluator& evaluator);

  /// Of the ranges: parameter - lower, upper - parameter; of each order: greater - smaller.
  const std::vector<Fact>& facts() const { return facts_; }

  /// A scalar that is zero: a component of left - right of an equation, with values for its
  /// parameters, perhaps after derivatives.
  /// @throws Rejection when there is no such equation, or when it need not hold there
  /// @throws Unsupported when it is not clear that the values are in the ranges
  Fact instance(const Cofactor& of) const;

 private:
  struct Bounds {
    Quotient lower;
    Quotient upper;
  };

  void require_differentiable(SymbolIndex parameter, const Cofactor& of) const;
  void require_in_range(const Cofactor::At& at, const Quotient& value, const Images& images) const;
  bool is_other_parameter_of_range(const Quotient& value, const Bounds& bounds) const;

  const Sequent& sequent_;
  const Certificate& certificate_;
  Evaluator& evaluator_;
  Field& field_;
  std::vector<Fact> facts_;
  std::map<SymbolIndex, Bounds> bounds_;
  Box box_;
  /// Parameters that hypotheses other than equations are about.
  std::set<SymbolIndex> restricted_;
};

}  // namespace recheck
