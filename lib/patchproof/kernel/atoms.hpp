#pragma once

#include <map>
#include <tuple>
#include <vector>

#include <patchproof/algebra/fraction.hpp>
#include <patchproof/term/symbol.hpp>

namespace patchproof {

/// What a variable of the kernel's polynomials stands for.
struct Atom {
  enum class Kind {
    symbol,       ///< a scalar symbol, or one component of a point symbol
    jet,          ///< one component of a derivative of an unknown function at some arguments
    slot,         ///< the k-th formal argument of an unknown function
    pi,           ///< the number pi
    sine,         ///< sin(argument)
    cosine,       ///< cos(argument)
    exponential,  ///< exp(argument)
    root,         ///< the square root, not negative, of the argument (a polynomial)
    running,      ///< the k-th variable of an integral, bound there; arguments: lower, upper end
    integral,     ///< the integral of the first argument over the variables that follow it
  };
  Kind kind = Kind::symbol;
  SymbolPointer symbol;             ///< symbol, jet, slot
  int component = 0;                ///< symbol, jet; slot: which argument; running: which variable
  std::vector<int> orders;          ///< jet: order of the derivative in each argument
  std::vector<Fraction> arguments;  ///< jet: where; sine, cosine, exponential, root: of what

  friend bool operator<(const Atom& a, const Atom& b);
};

/// The variables in use while one claim is decided, in both directions.
class Atoms {
 public:
  /// The variable that stands for the atom; a new one at first sight.
  Variable variable(const Atom& atom);
  Variable symbol(const SymbolPointer& symbol, int component = 0);
  Variable slot(const SymbolPointer& function, int argument);

  const Atom& operator[](Variable variable) const { return atoms_.at(variable); }
  std::size_t size() const { return atoms_.size(); }

  /// Whether any sine or root, whose squares have to be rewritten, has been made.
  bool has_relations() const { return has_relations_; }

 private:
  std::vector<Atom> atoms_;
  std::map<Atom, Variable> variables_;
  bool has_relations_ = false;
};

}  // namespace patchproof
