#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include <patchproof/kernel/evaluator.hpp>

namespace patchproof {

/// A point of space with exact coordinates.
using Point = std::array<Rational, 3>;

Point operator+(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);
Point operator*(const Rational& factor, const Point& a);
Rational dot(const Point& a, const Point& b);
Point cross(const Point& a, const Point& b);

/// The number a fraction is worth where its variables have these values: exact where it is a
/// fraction of polynomials in them, else the middle of an enclosure of less than 2^-40. Empty where
/// a denominator vanishes.
/// @throws OutsideTheory when it contains something without value.
std::optional<Rational> number_at(const Fraction& fraction, const std::map<Variable, Rational>& at,
                                  Workspace& workspace);

/// The interval of a parameter; its ends may contain the parameter before it.
struct ParameterInterval {
  Fraction low{Rational{0}};
  Fraction high{Rational{1}};
};

/// A function of at most two parameters, with up to three coordinates, whose values can be worked
/// out at places of its domain. Domains are described by numbers from 0 to 1.
class SampledFunction {
 public:
  /// `variables` are the parameters; `ranges` as many intervals.
  SampledFunction(std::vector<Fraction> coordinates, std::vector<Variable> variables,
                  std::vector<ParameterInterval> ranges, Workspace& workspace);

  std::size_t parameter_count() const { return variables_.size(); }
  const std::vector<Fraction>& coordinates() const { return coordinates_; }
  const std::vector<Variable>& variables() const { return variables_; }

  /// The parameters at a place of the domain: (0, 0) is the lower end of both.
  std::vector<Rational> parameters(const std::vector<Rational>& place) const;

  /// The value there; coordinates that do not exist are 0. Where a denominator vanishes, the value
  /// a little nearer to the middle of the domain stands for it.
  /// @throws OutsideTheory when there is none either.
  Point value(const std::vector<Rational>& place) const;

  /// The derivative of these orders in the parameters (not in the numbers from 0 to 1).
  SampledFunction derivative(const std::vector<int>& orders) const;

 private:
  std::optional<Point> value_at(const std::vector<Rational>& place) const;

  std::vector<Fraction> coordinates_;
  std::vector<Variable> variables_;
  std::vector<ParameterInterval> ranges_;
  Workspace* workspace_;
};

}  // namespace patchproof
