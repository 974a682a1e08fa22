#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchproof/algebra/quadratic_form.hpp>
#include <patchproof/kernel/unknowns.hpp>

namespace patchproof {

/// A functional around a candidate, as a polynomial in what the constraints leave free:
/// value(candidate + directions * y) - value(candidate).
class MinimumSearch {
 public:
  MinimumSearch(const MinimumGoal& goal, Workspace& workspace);

  /// Finds the candidate among the competitors, the free directions and the polynomial. Says why
  /// the claim has no meaning: the candidate is no competitor; "" when all is well.
  /// @throws OutsideTheory when constraints are not linear or the functional not quadratic
  std::string set_up();

  /// The coefficient of each y; zero where the candidate is stationary.
  const std::vector<Polynomial>& linear_part() const { return linear_; }
  /// The second derivatives; empty when they are not all numbers.
  std::optional<std::vector<std::vector<Rational>>> hessian() const;
  /// An entry of the Hessian that is not a number; zero when there is none.
  Polynomial symbolic_entry() const;
  /// What the values and constraints need to have a meaning.
  const Conditions& conditions() const { return conditions_; }
  Hypotheses& hypotheses() { return hypotheses_; }

  /// The control point whose coordinate is the f-th free one, in words.
  std::string direction_name(std::size_t f) const;

  /// When there are no symbols but the unknowns: values for them with a smaller functional.
  std::optional<std::vector<KnownValue>> better_competitor();

  /// The functional of the competitor and that of the candidate, each equal to the polynomial that was
  /// worked out for it: what the second engine can check.
  Goal values_as_claim();

 private:
  std::string place_candidate();
  std::string violated_constraint();
  void find_directions();
  void expand();
  void add_conditions(const UnknownSystem& system);
  Fraction difference_of(const Statement& statement);
  /// An unknown at the candidate plus the directions times y.
  Fraction moved(std::size_t unknown);
  std::optional<std::vector<KnownValue>> values(const std::vector<Fraction>& coordinates);

  const MinimumGoal& goal_;
  Workspace& workspace_;
  Evaluator evaluator_;
  Hypotheses hypotheses_;
  std::vector<Variable> variables_;
  std::vector<Fraction> candidate_;                ///< its coordinate for each variable
  std::vector<std::size_t> free_;                  ///< which variables are y
  std::vector<std::vector<Rational>> directions_;  ///< [variable][position in free]
  Polynomial difference_;
  std::vector<Polynomial> linear_;
  std::vector<std::vector<Polynomial>> second_;
  Conditions conditions_;
};

}  // namespace patchproof
