#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <recheck/document.hpp>
#include <recheck/polynomial.hpp>

namespace recheck {

/// A polynomial divided by powers of polynomials that are no numbers and have leading coefficient
/// 1. Nothing is cancelled.
struct Quotient {
  Polynomial numerator;
  std::map<Polynomial, unsigned, PolynomialOrder> denominator;
};

/// What an atom stands for.
struct Meaning {
  enum class Kind {
    coordinate,  ///< of a symbol that is a scalar or point
    slot,        ///< an argument of an unknown function that stands alone
    jet,         ///< a coordinate of a derivative of an unknown function, at some arguments
    root,        ///< the square root, not negative, of a whole number without square factors
  };
  Kind kind = Kind::coordinate;
  SymbolIndex symbol = 0;
  /// Which coordinate or argument.
  std::size_t index = 0;
  std::vector<std::size_t> orders;
  std::vector<Quotient> arguments;
  Integer radicand;
  /// How many functions there are within functions.
  std::size_t depth = 0;
};

/// The rational functions in atoms, and the atoms.
class Field {
 public:
  Field(const std::vector<Symbol>& symbols, Meter& meter) : symbols_{symbols}, meter_{meter} {}

  Meter& meter() const { return meter_; }
  const Symbol& symbol(SymbolIndex index) const { return symbols_.at(index); }
  const Meaning& meaning(Atom atom) const { return meanings_.at(atom); }

  Atom coordinate(SymbolIndex symbol, std::size_t index);
  Atom slot(SymbolIndex function, std::size_t index);
  /// Equal arguments give the same atom.
  /// @throws Rejection when the function need not have so many derivatives
  Atom jet(SymbolIndex function, std::size_t index, const std::vector<std::size_t>& orders,
           const std::vector<Quotient>& arguments);
  /// The square root of a number that is not negative.
  /// @throws Unsupported when it has a large factor that is neither prime for sure nor a square
  Quotient square_root(const Rational& number);

  Quotient sum(const Quotient& a, const Quotient& b);
  Quotient difference(const Quotient& a, const Quotient& b);
  Quotient product(const Quotient& a, const Quotient& b);
  Quotient power(const Quotient& a, std::size_t exponent);
  /// 1/a. Whoever asks has to remember that the numerator must not vanish.
  /// @throws Rejection when a is zero
  Quotient inverse(const Quotient& a);
  Quotient multiple(const Quotient& a, const Rational& factor);

  /// The polynomial with leading coefficient 1, as what must not vanish.
  Polynomial monic(const Polynomial& a);

  /// The beginning of its text, for messages.
  std::string text(const Polynomial& a) const;
  std::string text(const Quotient& a) const;
  std::string text(Atom atom) const;

 private:
  using Key = std::tuple<Meaning::Kind, SymbolIndex, std::size_t, std::vector<std::size_t>>;

  Atom fresh(const Key& key, Meaning meaning);
  Atom root(const Integer& radicand);
  bool equal(const std::vector<Quotient>& a, const std::vector<Quotient>& b);
  Polynomial without_squares_of_roots(Polynomial a);

  const std::vector<Symbol>& symbols_;
  Meter& meter_;
  std::vector<Meaning> meanings_;
  std::map<Key, std::vector<Atom>> found_;
  std::map<Integer, Atom> roots_;
};

inline Quotient as_quotient(Polynomial a) { return {std::move(a), {}}; }
inline Quotient number(const Rational& a) { return {constant(a), {}}; }
inline Quotient of_atom(Atom atom) { return {variable(atom), {}}; }

/// Whether it is a number without roots, and which.
std::optional<Rational> number_in(const Quotient& a);

/// All atoms, also of the arguments of functions.
std::set<Atom> atoms_within(const Quotient& a, const Field& field);

}  // namespace recheck
