#include <patchproof/figure/sampled_function.hpp>

#include <stdexcept>

#include <patchproof/figure/decimal.hpp>
#include <patchproof/figure/enclosure_at.hpp>
#include <patchproof/kernel/transformation.hpp>

namespace patchproof {

namespace {

constexpr unsigned drawn_bits = 40;

// The value of a polynomial in the given variables alone; empty when there are others.
std::optional<Rational> exact_value(const Polynomial& polynomial,
                                    const std::map<Variable, Rational>& at, Budget& budget) {
  Rational total = 0;
  for (const auto& term : polynomial.terms()) {
    Rational part = term.coefficient;
    for (const auto& p : term.monomial.powers()) {
      const auto value = at.find(p.variable);
      if (value == at.end()) return std::nullopt;
      budget.spend(coefficient_cost(part, value->second));
      part *= power(value->second, static_cast<long>(p.exponent));
    }
    total += part;
  }
  return total;
}

enum class Exactness { exact, no_value, inexact };

std::pair<Exactness, Rational> exact_value(const Fraction& fraction,
                                           const std::map<Variable, Rational>& at, Budget& budget) {
  const std::optional<Rational> numerator = exact_value(fraction.numerator(), at, budget);
  if (!numerator) return {Exactness::inexact, 0};
  Rational result = *numerator;
  for (const auto& [factor, exponent] : fraction.denominator()) {
    const std::optional<Rational> divisor = exact_value(factor, at, budget);
    if (!divisor) return {Exactness::inexact, 0};
    if (*divisor == 0) return {Exactness::no_value, 0};
    result /= power(*divisor, static_cast<long>(exponent));
  }
  return {Exactness::exact, result};
}

}  // namespace

Point operator+(const Point& a, const Point& b) {
  return {Rational{a[0] + b[0]}, Rational{a[1] + b[1]}, Rational{a[2] + b[2]}};
}

Point operator-(const Point& a, const Point& b) { return a + Rational{-1} * b; }

Point operator*(const Rational& factor, const Point& a) {
  return {Rational{factor * a[0]}, Rational{factor * a[1]}, Rational{factor * a[2]}};
}

Rational dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point cross(const Point& a, const Point& b) {
  return {Rational{a[1] * b[2] - a[2] * b[1]}, Rational{a[2] * b[0] - a[0] * b[2]},
          Rational{a[0] * b[1] - a[1] * b[0]}};
}

std::optional<Rational> number_at(const Fraction& fraction, const std::map<Variable, Rational>& at,
                                  Workspace& workspace) {
  const auto [exactness, value] = exact_value(fraction, at, workspace.budget);
  if (exactness == Exactness::no_value) return std::nullopt;
  if (exactness == Exactness::exact) return value;
  for (unsigned bits = 64; bits <= 512; bits *= 2) {
    const std::optional<Enclosure> found =
        enclosure_at(fraction, at, workspace.atoms, bits, workspace.budget);
    if (!found || found->high - found->low > Rational{1, Integer{1} << drawn_bits}) continue;
    return rounded(Rational{(found->low + found->high) / 2}, drawn_bits);
  }
  return std::nullopt;
}

SampledFunction::SampledFunction(std::vector<Fraction> coordinates, std::vector<Variable> variables,
                                 std::vector<ParameterInterval> ranges, Workspace& workspace)
    : coordinates_{std::move(coordinates)},
      variables_{std::move(variables)},
      ranges_{std::move(ranges)},
      workspace_{&workspace} {}

std::vector<Rational> SampledFunction::parameters(const std::vector<Rational>& place) const {
  std::map<Variable, Rational> at;
  std::vector<Rational> result;
  for (std::size_t k = 0; k < variables_.size(); ++k) {
    const std::optional<Rational> low = number_at(ranges_[k].low, at, *workspace_);
    const std::optional<Rational> high = number_at(ranges_[k].high, at, *workspace_);
    if (!low || !high) throw OutsideTheory{"the range of a parameter is no interval of numbers"};
    result.push_back(*low + place[k] * (*high - *low));
    at.emplace(variables_[k], result.back());
  }
  return result;
}

std::optional<Point> SampledFunction::value_at(const std::vector<Rational>& place) const {
  std::map<Variable, Rational> at;
  const std::vector<Rational> its_parameters = parameters(place);
  for (std::size_t k = 0; k < variables_.size(); ++k) at.emplace(variables_[k], its_parameters[k]);
  Point result{};
  for (std::size_t k = 0; k < coordinates_.size(); ++k) {
    const std::optional<Rational> coordinate = number_at(coordinates_[k], at, *workspace_);
    if (!coordinate) return std::nullopt;
    result[k] = *coordinate;
  }
  return result;
}

Point SampledFunction::value(const std::vector<Rational>& place) const {
  if (const std::optional<Point> found = value_at(place)) return *found;
  // Patches with a corner that is no point but a limit: 0/0 there, and nowhere near.
  std::vector<Rational> nearer;
  const Rational step{1, 4096};
  for (const Rational& p : place) nearer.push_back(p + step * (Rational{1, 2} - p));
  if (const std::optional<Point> found = value_at(nearer)) return *found;
  throw OutsideTheory{"it has no value at some of its places"};
}

SampledFunction SampledFunction::derivative(const std::vector<int>& orders) const {
  SampledFunction result = *this;
  Conditions ignored;
  for (std::size_t k = 0; k < orders.size(); ++k)
    for (int order = 0; order < orders[k]; ++order)
      for (Fraction& coordinate : result.coordinates_)
        coordinate = patchproof::derivative(coordinate, variables_[k], ignored, *workspace_);
  return result;
}

}  // namespace patchproof
