#pragma once

#include <recheck/field.hpp>

namespace recheck {

/// Polynomials that are shown not to vanish.
class Divisors {
 public:
  explicit Divisors(Field& field) : field_{field} {}

  void add(const Polynomial& shown) { shown_.push_back(shown); }

  /// Requires that none of the polynomials vanishes: each divides what was added, or products of
  /// it, up to a number.
  /// @throws Rejection
  void require(const Polynomials& divisors) const;

 private:
  bool is_shown(const Polynomial& divisor) const;

  Field& field_;
  std::vector<Polynomial> shown_;
};

}  // namespace recheck
