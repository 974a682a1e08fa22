#pragma once

#include <random>

#include <patchproof/kernel/elementary.hpp>
#include <patchproof/kernel/transformation.hpp>

#include "algebra/random_algebra.hpp"

namespace patchproof {

/// A workspace with parameters u and v, a scalar a and an unknown scalar function f of one
/// parameter, C^6.
struct Tools {
  Budget budget{Limits{}};
  Workspace workspace{budget};
  SymbolPointer f_symbol =
      symbol("f", Symbol::Role::function, Type::function({"t"}, Type::scalar()), 9);
  Fraction u = Polynomial::variable(
      workspace.atoms.symbol(symbol("u", Symbol::Role::parameter, Type::scalar(), 1)));
  Fraction v = Polynomial::variable(
      workspace.atoms.symbol(symbol("v", Symbol::Role::parameter, Type::scalar(), 2)));
  Fraction a = Polynomial::variable(
      workspace.atoms.symbol(symbol("a", Symbol::Role::scalar, Type::scalar(), 3)));
  Fraction pi =
      Polynomial::variable(workspace.atoms.variable({Atom::Kind::pi, nullptr, 0, {}, {}}));

  static SymbolPointer symbol(const std::string& name, Symbol::Role role, const Type& type,
                              unsigned ordinal) {
    return std::make_shared<const Symbol>(Symbol{name, role, type, 6, ordinal});
  }
  static Variable variable_of(const Fraction& symbol) { return *variables(symbol).begin(); }
  /// The derivative of f of the given order, at a place.
  Fraction f(const Fraction& place, int order = 0) {
    return Polynomial::variable(
        workspace.atoms.variable({Atom::Kind::jet, f_symbol, 0, {order}, {place}}));
  }
  Fraction add(const Fraction& x, const Fraction& y) { return sum(x, y, budget); }
  Fraction minus(const Fraction& x, const Fraction& y) { return difference(x, y, budget); }
  Fraction times(const Fraction& x, const Fraction& y) { return product(x, y, budget); }
  Fraction over(const Fraction& x, const Fraction& y) { return quotient(x, y, budget); }
  Fraction in_normal_form(const Fraction& x) { return normal_form(x, workspace); }
  bool equal(const Fraction& x, const Fraction& y) { return in_normal_form(minus(x, y)).is_zero(); }

  /// Runs `body` again whenever angles had to be cut finer.
  template <class Body>
  void with_finer_angles(const Body& body) {
    for (;;) {
      try {
        body();
        return;
      } catch (const FinerAngles&) {
      }
    }
  }

  /// A polynomial in u, a, sin(u), cos(2u), exp(u), f(u), f'(u^2).
  Fraction random_value(std::mt19937& random) {
    const std::vector<Fraction> atoms{u,
                                      a,
                                      sine(u, workspace),
                                      cosine(times(u, Rational{2}), workspace),
                                      exponential(u, workspace),
                                      f(u),
                                      f(times(u, u), 1)};
    Fraction result;
    for (int k = 0; k < 3; ++k) {
      Fraction term{random_rational(random)};
      for (unsigned j = 0; j < 1 + random() % 2; ++j)
        term = times(term, atoms[random() % atoms.size()]);
      result = add(result, term);
    }
    return in_normal_form(result);
  }
};

}  // namespace patchproof
