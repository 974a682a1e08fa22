#pragma once

#include <patchproof/language/elaborator.hpp>

namespace patchproof {

/// A net (two binders) or list (one) of the values of an expression; indices start at 0.
Term net_of(const syntax::Expression& value, const std::vector<syntax::Binder>& binders,
            const Span& span, const Scope& scope, Elaborator& elaborator);

/// The net of a file, of scalars where its points have one coordinate; a list where it has one row.
Term net_from(const syntax::FileName& file, const Scope& scope, Elaborator& elaborator);

/// segment(T, i) or segment(T, i, j): the piece of a spline over one knot span (the i-th one that
/// is not empty, from 0), as a function of local parameters in [0,1].
/// Source: Piegl & Tiller, The NURBS Book, 2.2 and 3.4.
Term segment(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator);

/// bezier_net(T): the Bézier points of all pieces, neighbours sharing a row: degree * pieces + 1
/// points in each direction. Needs at least C^0, that is multiplicities up to the degree inside.
/// Source: Farin, Curves and Surfaces for CAGD, ch. 8 (blossoms of B-splines).
Term bezier_net(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator);

/// bezier_weights(T): the weights of those points, of a rational spline.
Term bezier_weights(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator);

/// control_points(T)
Term control_points(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator);

/// weights(T), of a rational spline.
Term weights(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator);

/// knots(T) of a curve, knots(T, u) of a surface: all knots, as a list.
Term knots(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator);

/// greville(T), greville(T, u): for each control point the mean of `degree` neighbouring knots.
/// Source: Farin, Curves and Surfaces for CAGD, ch. 8 (Greville abscissae).
Term greville(const syntax::Expression& call, const Scope& scope, Elaborator& elaborator);

/// The direction a call names as its second argument, for a surface; `others` arguments come after
/// the spline and the direction. The two texts say how the arguments go, for the message.
std::size_t direction_of(const Spline& spline, const syntax::Expression& call, std::size_t others,
                         const char* arguments, const char* surface_arguments);

/// A spline from its declaration; Fault for knots that do not fit.
Spline declared_spline(const syntax::SplineData& data, const Scope& scope, Elaborator& elaborator);

}  // namespace patchproof
