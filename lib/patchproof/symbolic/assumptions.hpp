#pragma once

#include <ginac/ginac.h>

#include <set>
#include <vector>

#include <patchproof/symbolic/evaluation.hpp>
#include <patchproof/symbolic/substitution.hpp>
#include <patchproof/term/goal.hpp>

namespace patchproof::symbolic {

/// What follows from the equations among the assumptions, as replacements.
///
/// An equation is used when it can be solved for a symbol, for an unknown function at parameters
/// (which then is known everywhere), or for a value of an unknown function. Others, and those that
/// are no equations, are left aside.
class Assumptions {
 public:
  /// Equations with a symbol whose ordinal is in `kept` are left aside.
  /// @throws OverBudget
  /// @throws std::domain_error when the assumptions contradict each other.
  Assumptions(Ring& ring, Evaluation& evaluation, const std::vector<Assumption>& assumptions,
              const std::set<unsigned>& kept = {});

  /// The polynomial in what the assumptions leave undetermined.
  GiNaC::ex operator()(GiNaC::ex polynomial);

  /// Whether no equation was left aside.
  bool are_all_used() const { return are_all_used_; }

 private:
  void add_equation(const GiNaC::ex& equation);
  void use(Replacements replacements);
  bool has_kept(const GiNaC::ex& equation) const;
  bool use_for_function(std::size_t index);
  bool use_for_atom(std::size_t index, Atom::Kind kind);
  bool use_any();
  void split_by_parameters();

  Ring& ring_;
  std::set<unsigned> kept_;
  std::vector<GiNaC::ex> equations_;
  std::vector<Substitution> rules_;
  /// Atoms in the arguments of the values of functions that were replaced.
  std::set<unsigned> fixed_;
  bool are_all_used_ = true;
};

/// Whether the expression has a parameter of the goal in it, at any depth.
bool has_parameters(const Ring& ring, const GiNaC::ex& expression);

/// Whether the atom is, or has in its arguments, a parameter of the goal.
bool has_parameters(const Ring& ring, unsigned atom);

}  // namespace patchproof::symbolic
