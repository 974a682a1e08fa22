#pragma once

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/algebra/fraction.hpp>
#include <patchproof/kernel/atoms.hpp>
#include <patchproof/term/span.hpp>

namespace patchproof {

/// Something a value depends on: it means nothing where the condition fails.
struct Condition {
  enum class Kind { not_zero, at_least_zero };
  Kind kind = Kind::not_zero;
  Polynomial polynomial;
  friend bool operator<(const Condition& a, const Condition& b) {
    return a.kind != b.kind ? a.kind < b.kind : a.polynomial < b.polynomial;
  }
};
using Conditions = std::set<Condition>;

/// The term has no value at all: division by zero, the root of a negative number, a derivative
/// that is not assumed to exist. `span` is where.
class NoValue : public std::domain_error {
 public:
  NoValue(const std::string& message, Span where) : std::domain_error{message}, span{std::move(where)} {}
  Span span;
};

/// The kernel has no method for this; the verdict is UNKNOWN, and this is why.
class OutsideTheory : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown when angles have to be cut finer (`Workspace::angle_parts` has been raised): all values
/// made so far are to be forgotten and the claim started again.
class FinerAngles : public std::exception {};

/// The variables and the budget of one claim.
///
/// sin and cos of rational multiples of one angle m are polynomials in sin(m/d) and cos(m/d) for a
/// common denominator d. The denominators are found on the way, see `FinerAngles`.
struct Workspace {
  explicit Workspace(Budget& b) : budget{b} {}
  Budget& budget;
  Atoms atoms;
  /// Angle -> number of parts d; angles are monomials (as fractions) or quotients as a whole.
  std::map<Fraction, Integer> angle_parts;
  /// The same for exponents of exp.
  std::map<Fraction, Integer> exponent_parts;
};

/// Squares of sines and of roots written out: sin^2 = 1 - cos^2, root^2 = radicand.
Fraction normal_form(const Fraction& fraction, Workspace& workspace);
Polynomial normal_form(const Polynomial& polynomial, Workspace& workspace);

}  // namespace patchproof
