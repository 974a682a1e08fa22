#pragma once

#include <ginac/ginac.h>

#include <map>
#include <utility>

#include <patchproof/symbolic/ring.hpp>

namespace patchproof::symbolic {

/// What stands in the place of one component of an unknown function: `value` is made of the atoms
/// `formals`, one for each parameter, and of others.
struct FunctionValue {
  std::vector<unsigned> formals;
  GiNaC::ex value;
};

/// What is replaced by what; all at once, also within the arguments of other atoms.
struct Replacements {
  std::map<unsigned, GiNaC::ex> atoms;
  /// For a function symbol's ordinal and a component: all derivatives at all arguments.
  std::map<std::pair<unsigned, int>, FunctionValue> functions;
};

/// Replaces atoms in any number of polynomials.
class Substitution {
 public:
  Substitution(Ring& ring, Replacements replacements);

  /// @throws OverBudget
  /// @throws std::domain_error when a denominator becomes zero.
  GiNaC::ex operator()(const GiNaC::ex& polynomial);

 private:
  bool is_affected(unsigned id);
  const GiNaC::ex& image(unsigned id);
  GiNaC::ex new_image(const Atom& atom);
  GiNaC::ex image_of_jet(const Atom& atom, const FunctionValue& function);

  Ring& ring_;
  Replacements replacements_;
  std::map<unsigned, bool> affected_;
  std::map<unsigned, GiNaC::ex> images_;
};

}  // namespace patchproof::symbolic
