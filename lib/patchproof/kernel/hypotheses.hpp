#pragma once

#include <map>
#include <string>
#include <vector>

#include <patchproof/kernel/evaluator.hpp>
#include <patchproof/kernel/sign_facts.hpp>
#include <patchproof/kernel/transformation.hpp>

namespace patchproof {

/// The assumptions of a goal, solved: linear equations are turned into replacements, equations
/// between functions (f1(u) + f2(u) == 1 for all u) into a definition of one function by others,
/// inequalities into facts about signs.
///
/// Replacing is an equivalence: the claim holds under the equations exactly when the replaced claim
/// holds without them. Equations that cannot be solved this way are left out and named.
class Hypotheses {
 public:
  /// `enabled[k]` says whether assumption k of the goal may be used.
  Hypotheses(const Goal& goal, const std::vector<bool>& enabled, Evaluator& evaluator,
             Workspace& workspace);

  /// The fraction after all replacements.
  Fraction reduced(const Fraction& fraction);

  const SignFacts& facts() const { return facts_; }

  /// What the assumptions themselves need to have a value.
  const Conditions& conditions() const { return conditions_; }

  /// Checks that the parameters in the polynomial run over more than a point: only then does an
  /// equation for all of their values say something of its coefficients and derivatives.
  /// @throws OutsideTheory
  void require_proper_ranges(const Polynomial& polynomial) const;

  /// Checks that no inequality restricts a parameter of the polynomial: on what is left of its range
  /// an equation need not determine its coefficients.
  /// @throws OutsideTheory
  void require_unrestricted(const Polynomial& polynomial) const;

  /// True when the assumptions were found to contradict each other.
  bool contradictory() const { return contradictory_; }

  /// Why some equation could not be used: "assumption 'x' is not linear"; empty when all could.
  const std::vector<std::string>& left_out() const { return left_out_; }

  /// The equations behind that, as polynomials that have to vanish.
  const std::vector<Polynomial>& unsolved() const { return unsolved_; }

  /// A function that the assumptions express by others: its value at the bare parameters.
  struct Definition {
    std::vector<Variable> parameters;
    Fraction value;
  };
  /// How the assumptions define this component of the function; empty when they do not.
  std::optional<Definition> definition(const Symbol& function, int component) const;

  /// A function whose values on an edge the assumptions give: r(u,0) == C1(u), or r_v(u,0) == 0.
  struct EdgeValue {
    /// For each argument its value on the edge; empty for those that run along it.
    std::vector<std::optional<Rational>> fixed;
    /// The derivative across the edge whose value is given; zero along it.
    std::vector<int> orders;
    /// The parameters in the arguments that run along the edge, and the value there.
    Definition definition;
  };
  /// The edges of this component of the function on which its values are assumed.
  std::vector<EdgeValue> edges(const Symbol& function, int component) const;

 private:
  struct Range {
    Fraction low;
    Fraction high;
  };

  void add_ranges(const Goal& goal, Evaluator& evaluator);
  void find_restricted(const Goal& goal, const std::vector<bool>& enabled, Evaluator& evaluator);
  void add_equation(const Polynomial& equation, const std::string& name);
  bool define_function(const Polynomial& equation);
  bool define_edge(const Polynomial& equation);
  bool split_by_parameters(const Polynomial& equation, const std::string& name);
  bool replace_variable(const Polynomial& equation);
  void add_facts(const Goal& goal, const std::vector<bool>& enabled, Evaluator& evaluator);

  void require_proper_range(Variable parameter) const;
  /// Whether an end of its range contains parameters.
  bool has_dependent_range(Variable parameter) const;
  std::set<Variable> parameters_in(const Polynomial& polynomial) const;
  /// The replacements that matter for the fraction.
  std::map<Variable, Fraction> images_for(const Fraction& fraction);
  Fraction function_value(const Definition& definition, const Atom& jet);
  /// The jet by what is assumed on an edge it lies on; empty when it lies on none.
  std::optional<Fraction> edge_value(const Atom& jet);
  /// Whether the arguments are shown to lie in the ranges of the parameters they stand for, also
  /// where the ends of one range contain other parameters: v in [0, u].
  bool are_in_range(const std::vector<Variable>& parameters,
                    const std::vector<Fraction>& arguments) const;

  Workspace& workspace_;
  std::map<Variable, Range> ranges_;
  std::map<Variable, Fraction> images_;
  std::map<std::pair<unsigned, int>, Definition> functions_;
  std::map<std::pair<unsigned, int>, std::vector<EdgeValue>> edges_;
  std::map<Variable, Fraction> function_images_;
  SignFacts facts_;
  Conditions conditions_;
  bool contradictory_ = false;
  std::vector<std::string> left_out_;
  std::vector<Polynomial> unsolved_;
  /// Parameters that inequalities are about, and those that an order is about: where u <= v holds
  /// may be so little that an equation there says nothing of other places. u != v leaves out too
  /// little to matter to continuous functions.
  std::set<Variable> restricted_;
  std::set<Variable> ordered_;
};

/// All variables of the polynomial and of the arguments of its atoms, at any depth.
std::set<Variable> variables_within(const Polynomial& polynomial, const Atoms& atoms);

}  // namespace patchproof
