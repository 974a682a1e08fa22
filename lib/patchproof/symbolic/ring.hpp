#pragma once

#include <ginac/ginac.h>

#include <cstddef>
#include <cstdint>

#include <patchproof/algebra/budget.hpp>
#include <patchproof/symbolic/atoms.hpp>
#include <patchproof/symbolic/polynomial.hpp>

namespace patchproof::symbolic {

/// The polynomials in atoms, always expanded, and what computing with them may cost.
///
/// A call into GiNaC cannot be interrupted, so the size of each result is estimated first and large
/// products are formed in pieces. Squares of root atoms are replaced by their radicands.
class Ring {
 public:
  explicit Ring(const Limits& limits);

  Atoms& atoms() { return atoms_; }
  const Atoms& atoms() const { return atoms_; }

  /// @throws OverBudget
  GiNaC::ex sum(const GiNaC::exvector& parts);

  /// @throws OverBudget
  GiNaC::ex product(const GiNaC::ex& a, const GiNaC::ex& b);

  /// base^exponent for an exponent that is not negative.
  /// @throws OverBudget
  GiNaC::ex power(const GiNaC::ex& base, unsigned long exponent);

  /// Notes that work was done.
  /// @throws OverBudget
  void spend(std::uint64_t steps) { budget_.spend(steps); }

 private:
  void require_terms(std::size_t terms) const;
  void require_bits(std::size_t terms, std::size_t bits) const;
  GiNaC::ex product_in_pieces(const GiNaC::ex& a, const GiNaC::ex& b);
  GiNaC::ex without_squares_of_roots(const GiNaC::ex& polynomial);

  Atoms atoms_;
  Budget budget_;
  std::size_t most_terms_;
};

}  // namespace patchproof::symbolic
