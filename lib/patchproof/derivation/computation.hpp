#pragma once

#include <optional>
#include <string>

#include <patchproof/derivation/case_derivation.hpp>
#include <patchproof/derivation/unfolding.hpp>

namespace patchproof {

/// Works out values step by step, as chains of equations.
///
/// A chain begins with the value as written; name after name is written out, derivatives are carried
/// out, numbers worked out; it ends with the polynomial collected by the unknowns. What is too long
/// to be read is left out. All of it is a proposal that still has to be decided.
class Computation {
 public:
  Computation(LatexNames& names, Detail detail, const Limits& limits)
      : names_{names}, unfolding_{names}, detail_{detail}, limits_{limits} {}

  /// The chain of a value; without links when nothing can be said about it.
  Chain of(const Term& value);

  /// r_uu and r_uuv for r_uuvv at the parameters, as far as each can be said briefly.
  std::vector<Chain> lower_derivatives(const Term& value);

  /// What a name stands for, as written; for another name also what that one stands for.
  Chain definition(const Term& value, const Term& body);

  /// The value collected by the unknowns, in the order a person writes it; empty where it is none or
  /// the limits do not suffice.
  std::optional<Term> collected(const Term& value,
                                const std::vector<KnownValue>& known = {}) const;

  /// Whether the two are written alike.
  bool same(const Term& a, const Term& b) const;

  /// Whether the term is short enough to be printed.
  bool is_readable(const Term& term) const;

  /// The terms that have names, and more names for terms made on the way.
  std::vector<NamedTerm> named_terms() const { return names_.all(); }
  const std::string* name_of(const Term& term) const { return names_.name_of(term); }
  void add_name(const Term& term, const std::string& name) { names_.add(term, name); }

  const Limits& limits() const { return limits_; }

  /// Whether the term is not too long, however wide its matrices and fractions are.
  bool is_brief(const Term& term) const;

  /// Whether nothing in the term has a name that could be written out.
  bool is_plain(const Term& term) { return unfolding_.depth(term) == 0; }

 private:
  void append(Chain& chain, const Term& term, Reason reason) const;

  LatexNames& names_;
  Unfolding unfolding_;
  Detail detail_;
  Limits limits_;
};

}  // namespace patchproof
