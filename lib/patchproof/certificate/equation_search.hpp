#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include <patchproof/certificate/certificate.hpp>
#include <patchproof/kernel/evaluator.hpp>

namespace patchproof {

/// Finds how a difference is a sum of multiples of the equations of a sequent: instances of them are
/// chosen so that they speak of the same values of functions, and variables are eliminated one after
/// the other.
///
/// A heuristic; what it finds is the proof.
class EquationSearch {
 public:
  /// Variables of the symbols in `unknowns` are eliminated before others.
  EquationSearch(const Sequent& sequent, const std::set<unsigned>& unknowns, Evaluator& evaluator,
                 Workspace& workspace);

  /// A polynomial written as a rest plus multiples of instances, by their indices.
  struct Reduced {
    Polynomial rest;
    std::map<std::size_t, Polynomial> multiples;
  };

  /// The polynomial with all variables that the equations determine eliminated.
  Reduced reduced(const Polynomial& polynomial);

  /// numerator(difference) = sum of multiples * numerator(instance), as cofactors of a difference.
  std::vector<Cofactor> cofactors(const std::map<std::size_t, Polynomial>& multiples,
                                  const Fraction& difference);

  /// What the equations used so far divide by.
  const Conditions& conditions() const { return conditions_; }

 private:
  struct Equation {
    std::size_t hypothesis = 0;
    std::size_t component = 0;
    Fraction difference;
    std::vector<Variable> parameters;
    /// Other hypotheses restrict the parameters: they cannot be chosen.
    bool restricted = false;
  };
  struct Chosen {
    const Equation* equation = nullptr;
    std::vector<Fraction> at;
    std::vector<int> orders;
    Fraction difference;
  };
  /// A combination of instances in which the pivot occurs with a leading coefficient that is a number.
  struct Row {
    Reduced combination;
    Variable pivot = 0;
    unsigned degree = 1;
  };

  void choose_for(const Polynomial& polynomial);
  void choose_at_values_of(const Atom& jet);
  void sample(const Equation& equation);
  void add(const Equation& equation, const std::vector<std::optional<Fraction>>& at,
           const std::vector<int>& orders);
  void add_row(std::size_t chosen);
  void reduce(Reduced& state);
  std::optional<Row> row_of(const Reduced& combination) const;

  const Sequent& sequent_;
  const std::set<unsigned>& unknowns_;
  Workspace& workspace_;
  std::vector<Equation> equations_;
  std::vector<Chosen> chosen_;
  std::set<std::pair<std::size_t, std::vector<Fraction>>> tried_;
  std::set<Variable> seen_;
  std::vector<Row> rows_;
  Conditions conditions_;
};

}  // namespace patchproof
