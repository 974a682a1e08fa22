#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <patchproof/term/goal.hpp>

namespace patchproof {

/// For all functions, points and scalars: if the hypotheses hold, so do the conclusions, for all
/// values of the parameters in their ranges.
///
/// A hypothesis that is an equation holds for all values of the parameters in it, in their ranges
/// and where the other hypotheses about these parameters hold: `f1(u) + f2(u) == 1`. One of another
/// form restricts the parameters of the conclusions: `u <= v`.
struct Sequent {
  std::vector<Assumption> hypotheses;
  /// Of every parameter that occurs and has one.
  std::vector<ParameterRange> ranges;
  std::vector<Statement> conclusions;
};

/// A component of a hypothesis that is an equation, at some values of its parameters.
struct Instance {
  std::size_t hypothesis = 0;
  /// Of the two sides, as values of their type: entries row by row, coordinates in order.
  std::size_t component = 0;
  /// A scalar for each parameter of the hypothesis, in the order of their ordinals.
  std::vector<Term> at;
  /// How often the equation is differentiated in each of them before. All zero: not at all.
  std::vector<int> orders;
};

/// A multiple of an equation: left - right of the instance, times the factor.
struct Cofactor {
  Instance equation;
  Term factor;
};

/// coefficient * (product of the squares) * (product of the facts), never negative.
struct Summand {
  /// Positive.
  Rational coefficient = 1;
  /// Scalars that are squared.
  std::vector<Term> squares;
  /// Index of a fact, and its exponent, at least 1.
  std::vector<std::pair<std::size_t, unsigned>> facts;
};

/// Shows p >= 0: p is the sum of the summands and of the multiples of equations. It shows p > 0 when
/// there is a summand without squares all of whose facts are strict; the empty product is.
struct Combination {
  std::vector<Summand> summands;
  std::vector<Cofactor> cofactors;
};

/// Shows that a scalar is not negative, or positive, from facts: scalars known to be so.
///
/// The first facts are given by the sequent, see `facts_of`. A step adds the fact it shows after the
/// last one. A cut makes two cases: the scalar is a fact in the first, its negative in the second.
/// The last combination, in each case, shows the goal itself.
struct SignProof {
  struct Step {
    Term fact;
    bool strict = false;
    Combination why;
  };
  struct Cut {
    Term at;
    std::vector<SignProof> cases;  ///< two
  };
  std::vector<Step> steps;
  std::variant<Combination, Cut> end;
};

/// A scalar that does not vanish: because a hypothesis says left != right, or for its sign.
struct NonZero {
  Term scalar;
  /// The hypothesis, between scalars, of which it is left - right; or none.
  std::optional<std::size_t> hypothesis;
  /// Shows that the scalar, or with `negative` its negative, is positive.
  std::optional<SignProof> sign;
  bool negative = false;
};

/// Shows one component of a conclusion that is an equation:
/// left - right is the sum of the multiples of equations.
struct EquationProof {
  std::vector<Cofactor> cofactors;
};

/// Shows one component of a conclusion.
struct ComponentProof {
  std::size_t conclusion = 0;
  std::size_t component = 0;
  /// For == the multiples of equations. For an order: that the greater side minus the smaller one has
  /// its sign. For != that the difference, or its negative, is positive.
  std::variant<EquationProof, SignProof> why;
  /// Of !=: the difference is negative.
  bool negative = false;
};

/// A hint why some divisor does not vanish: factor * divisor is, but for a number, the product of these
/// scalars of `not_zero`, given by their indices.
struct Divisor {
  Term factor;
  std::vector<std::size_t> product;
};

/// Shows a sequent. Every divisor in it, and in the proof, is a divisor of a product of the scalars
/// in `not_zero`, times a number.
struct SequentProof {
  Sequent sequent;
  /// For every component of every conclusion; of != between points one component is enough.
  std::vector<ComponentProof> components;
  std::vector<NonZero> not_zero;
  std::vector<Divisor> divisors;
};

/// Values for all free symbols at which every hypothesis holds and one conclusion does not.
struct Refutation {
  Sequent sequent;
  /// Numbers, points, and polynomials for functions; parameters included.
  std::vector<KnownValue> values;
  std::size_t conclusion = 0;
  std::size_t component = 0;
};

/// What an independent checker needs to see that a verdict is right: statements and proof data.
struct Certificate {
  /// "case.label[i=0]"
  std::string claim;
  /// What was asked, in words of the case.
  std::string statement;
  /// All of them have to be shown. A derivation has two: the equations give the values, and the
  /// values satisfy the equations.
  std::variant<std::vector<SequentProof>, Refutation> content;
};

/// The facts a sequent gives to sign proofs, in this order: of each range parameter - lower and
/// upper - parameter; of each hypothesis <, <=, >, >= the greater side minus the smaller one.
struct Fact {
  Term scalar;
  bool strict = false;
};
std::vector<Fact> facts_of(const Sequent& sequent);

}  // namespace patchproof
