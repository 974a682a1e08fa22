#pragma once

#include <ginac/ginac.h>

#include <functional>
#include <map>
#include <utility>
#include <vector>

#include <patchproof/symbolic/atoms.hpp>

namespace patchproof::symbolic {

/// Atoms and their exponents (not 0, perhaps negative), by number of the atom.
using Powers = std::vector<std::pair<unsigned, long>>;

/// coefficient * product of powers of atoms.
struct Summand {
  GiNaC::numeric coefficient;
  Powers powers;
};

/// The summands of an expanded polynomial in atoms, ordered by their powers.
/// @throws std::logic_error when it is something else, or a coefficient is not exact.
std::vector<Summand> summands(const GiNaC::ex& polynomial, const Atoms& atoms);

/// The same in the order of GiNaC, which differs from process to process: for what does not depend
/// on it.
std::vector<Summand> unordered_summands(const GiNaC::ex& polynomial, const Atoms& atoms);

/// The product of powers of atoms.
GiNaC::ex monomial(const Powers& powers, const Atoms& atoms);

/// The polynomial with these summands.
GiNaC::ex polynomial(const std::vector<Summand>& summands, const Atoms& atoms);

/// The polynomial as one in the chosen atoms only: the coefficient of each of their monomials.
std::map<Powers, GiNaC::ex> coefficients(const GiNaC::ex& polynomial, const Atoms& atoms,
                                         const std::function<bool(unsigned)>& chosen);

/// How many summands an expanded polynomial has.
std::size_t term_count(const GiNaC::ex& polynomial);

/// The exponent of an atom among powers; 0 where it does not occur.
long exponent_of(const Powers& powers, unsigned id);

/// The lexicographic order of monomials: atoms with small numbers count more, exponents may be
/// negative.
bool is_larger(const Powers& a, const Powers& b);

/// The sum of the parts; none is expanded further.
GiNaC::ex sum(const GiNaC::exvector& parts);

}  // namespace patchproof::symbolic
