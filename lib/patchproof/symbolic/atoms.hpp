#pragma once

#include <ginac/ginac.h>

#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include <patchproof/term/term.hpp>

namespace patchproof::symbolic {

/// Something the polynomials of this engine do not look into. All terms become polynomials in
/// atoms (powers may be negative) with rational or complex rational coefficients.
struct Atom {
  enum class Kind {
    letter,       ///< one component of a parameter, scalar, point or bound symbol
    placeholder,  ///< the formal parameter number `component` of a function without names for them
    jet,          ///< one component of a derivative of an unknown function, at `arguments`
    pi,           ///< the number pi
    inverse,      ///< 1 / arguments[0]
    root,         ///< the square root of arguments[0]
    exponential,  ///< exp(arguments[0] / divisor), or exp(i * arguments[0] / divisor)
  };
  Kind kind = Kind::letter;
  SymbolPointer symbol;
  int component = 0;
  /// Jets: how often differentiated in each parameter.
  Indices orders;
  GiNaC::exvector arguments;
  /// Exponentials: a positive whole number; arguments[0] is a monomial with coefficient 1.
  GiNaC::numeric divisor = 1;
  bool imaginary = false;
  /// Roots: whether the radicand is a prime number.
  bool prime = false;
};

/// All atoms of one evaluation, numbered in the order they appeared. Walks over atoms go by number:
/// the order of GiNaC's own terms differs from process to process.
class Atoms {
 public:
  /// The GiNaC symbol for the atom; the same one for equal atoms.
  const GiNaC::ex& symbol_for(const Atom& atom);

  const Atom& at(unsigned id) const { return entries_[id].atom; }
  const GiNaC::ex& symbol(unsigned id) const { return entries_[id].symbol; }

  /// The atom and all atoms in its arguments, at any depth.
  const std::set<unsigned>& within(unsigned id) const { return entries_[id].within; }

  /// @throws std::logic_error for anything but a symbol made here.
  unsigned id_of(const GiNaC::ex& symbol) const;

  /// The atoms that occur in an expression, not looking into their arguments.
  std::set<unsigned> occurring(const GiNaC::ex& expression) const;

  /// The atoms that occur in an expression at any depth.
  std::set<unsigned> occurring_deeply(const GiNaC::ex& expression) const;

  /// Whether the atom's arguments have inverses, roots or exponentials: they may be equal to others
  /// that look different.
  bool is_related(unsigned id) const { return entries_[id].is_related; }

  std::size_t size() const { return entries_.size(); }
  bool has_roots() const { return has_roots_; }

 private:
  struct Entry {
    Atom atom;
    GiNaC::ex symbol;
    std::set<unsigned> within;
    bool is_related;
  };
  using Key = std::tuple<Atom::Kind, unsigned, int, Indices, bool>;

  // Entries stay where they are while others are added.
  std::deque<Entry> entries_;
  std::map<Key, std::vector<unsigned>> by_key_;
  std::map<GiNaC::ex, unsigned, GiNaC::ex_is_less> ids_;
  bool has_roots_ = false;
};

}  // namespace patchproof::symbolic
