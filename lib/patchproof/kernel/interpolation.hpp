#pragma once

#include <optional>
#include <vector>

#include <patchproof/algebra/polynomial.hpp>

namespace patchproof {

/// A prescribed value of a derivative: orders[k] times in variable k, at the place `at`.
struct Prescription {
  std::vector<int> orders;
  std::vector<Rational> at;
  Rational value;
};

/// A polynomial in the given variables, of the least total degree that suffices, with all the
/// prescribed values; empty when they contradict each other.
std::optional<Polynomial> interpolant(const std::vector<Prescription>& prescriptions,
                                      const std::vector<Variable>& variables, Budget& budget);

}  // namespace patchproof
