#pragma once

#include <patchproof/language/elaborator.hpp>

namespace patchproof {

/// Whether name(T, …) is a spline made of another one: insert_knot, elevate_degree.
bool changes_splines(const std::string& name);

/// The spline `name(arguments)`; the curve or surface stays the same.
/// @throws Fault
Spline changed_spline(const std::string& name, const syntax::Expression& call, const Scope& scope,
                      Elaborator& elaborator);

/// One knot more: Boehm's algorithm. Its multiplicity may reach the degree. A knot that is no
/// number can be inserted where it is written like one that is there.
/// Source: Boehm, Inserting new knots into B-spline curves, CAD 12 (1980).
Spline with_knot(const Spline& spline, std::size_t direction, const Term& knot,
                 Elaborator& elaborator, const Span& span);

/// One degree more: each knot has its multiplicity raised by one. The blossom of the higher degree
/// is the mean of the lower one's values with one argument left out. Source: Farin, Curves and
/// Surfaces for CAGD, ch. 8; Ramshaw, Blossoms are polar forms.
Spline with_higher_degree(const Spline& spline, std::size_t direction, Elaborator& elaborator,
                          const Span& span);

/// The spline as a net of Bézier points.
ControlNet bezier_form(const Spline& spline, Elaborator& elaborator, const Span& span);

}  // namespace patchproof
