#pragma once

#include <patchproof/kernel/interpolation.hpp>

namespace patchproof {

/// A derivative of a polynomial that is known where one variable has one value: of this order
/// across the edge, as a polynomial in the other variables.
struct EdgePolynomial {
  Variable slot = 0;
  Rational at;
  int order = 0;
  Polynomial value;
};

/// All polynomials with known values on edges: base + vanishing * anything.
struct Frame {
  Polynomial base;
  Polynomial vanishing;
};

/// Adds one more edge to the frame; the earlier ones keep their values where the edges agree.
/// A heuristic: edges that meet may need more. What comes of it has to be checked.
void add_edge(const EdgePolynomial& edge, Frame& frame, Budget& budget);

/// A polynomial in the given variables with the values of the frame and all the prescribed values;
/// empty when none of low degree was found.
std::optional<Polynomial> framed_interpolant(const std::vector<Prescription>& prescriptions,
                                             const Frame& frame,
                                             const std::vector<Variable>& variables,
                                             Budget& budget);

}  // namespace patchproof
