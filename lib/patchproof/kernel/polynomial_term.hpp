#pragma once

#include <optional>

#include <patchproof/kernel/workspace.hpp>
#include <patchproof/term/term.hpp>

namespace patchproof {

/// The scalar fraction as a term, in a fixed order. Components of points become `component` terms.
Term scalar_term(const Fraction& fraction, const Atoms& atoms);

/// The symbol or the jet an atom is (a component of), as a whole: the point V[0,1], C1'(0).
Term whole_term(const Atom& atom, const Atoms& atoms);

/// Components (as many as the type says) as a term of that type, scalar or point.
///
/// For a point of any dimension the fraction must be a sum of scalar multiples of points; empty
/// when it is not.
std::optional<Term> value_term(const std::vector<Fraction>& components, const Type& type,
                               const Atoms& atoms);

/// A function from polynomials in the given variables, one polynomial for each component.
Term polynomial_function(const std::vector<Polynomial>& components, const Type& type,
                         const std::vector<Variable>& variables);

}  // namespace patchproof
