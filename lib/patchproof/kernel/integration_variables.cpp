#include <patchproof/kernel/integration_variables.hpp>

#include <algorithm>

#include <patchproof/kernel/readable.hpp>
#include <patchproof/kernel/sign_facts.hpp>

namespace patchproof {

namespace {

bool variable_depends(Variable v, Variable on, const Atoms& atoms) {
  if (v == on) return true;
  const Atom& atom = atoms[v];
  const auto fraction_depends = [&](const Fraction& fraction) {
    const std::set<Variable> within = variables(fraction);
    return std::any_of(within.begin(), within.end(),
                       [&](Variable inner) { return variable_depends(inner, on, atoms); });
  };
  if (atom.kind == Atom::Kind::integral) {
    // Its own variables are bound in there; the ends they run between may still contain others.
    const IntegrationRanges own = ranges_of(atom, atoms);
    const bool bound_anew = std::any_of(own.begin(), own.end(), [&](const IntegrationRange& range) {
      return range.variable == on;
    });
    if (bound_anew)
      return std::any_of(own.begin(), own.end(), [&](const IntegrationRange& range) {
        return fraction_depends(range.lower) || fraction_depends(range.upper);
      });
  }
  return std::any_of(atom.arguments.begin(), atom.arguments.end(), fraction_depends);
}

void require_plain(const Fraction& fraction, const Atoms& atoms) {
  if (!fraction.is_polynomial())
    throw OutsideTheory{
        "the integral of a quotient whose divisor depends on a variable of the "
        "integral is not worked out in this version"};
  for (const Variable v : variables(fraction)) {
    const Atom& atom = atoms[v];
    if (atom.kind == Atom::Kind::root)
      throw OutsideTheory{
          "the integral of a root that depends on a variable of the integral is not worked out in "
          "this version"};
    if (atom.kind == Atom::Kind::integral)
      throw OutsideTheory{
          "an integral inside another that depends on its variables is not worked out in this "
          "version"};
    if (atom.kind == Atom::Kind::running) continue;
    for (const Fraction& argument : atom.arguments) require_plain(argument, atoms);
  }
}

// The interval if both ends are numbers, the lower one first.
std::optional<SignFacts::Interval> interval_of(const IntegrationRange& range) {
  for (const Fraction& end : {range.lower, range.upper})
    if (!end.is_polynomial() || !end.numerator().is_constant()) return std::nullopt;
  SignFacts::Interval result{range.lower.numerator().constant(),
                             range.upper.numerator().constant()};
  if (result.high < result.low) std::swap(result.low, result.high);
  return result;
}

// Where a polynomial in the one variable of an integral certainly vanishes; "" when it is not
// clear.
std::string place_of_zero(const Polynomial& p, const IntegrationRanges& ranges, Workspace& w) {
  for (const IntegrationRange& range : ranges) {
    const auto interval = interval_of(range);
    if (!interval || p.variables() != std::set<Variable>{range.variable}) continue;
    const auto at = [&](const Rational& x) {
      return substituted(p, {{range.variable, Polynomial{x}}}, w.budget).constant();
    };
    const std::string name = to_text(range.variable, w.atoms);
    for (const Rational& end : {interval->low, interval->high})
      if (at(end) == 0) return "at " + name + " = " + to_text(end);
    if (at(interval->low) * at(interval->high) < 0)
      return "for some " + name + " between " + to_text(interval->low) + " and " +
             to_text(interval->high);
  }
  return "";
}

}  // namespace

bool depends(const Polynomial& polynomial, const IntegrationRanges& ranges, const Atoms& atoms) {
  const std::set<Variable> within = polynomial.variables();
  return std::any_of(within.begin(), within.end(), [&](Variable v) {
    return std::any_of(ranges.begin(), ranges.end(), [&](const IntegrationRange& range) {
      return variable_depends(v, range.variable, atoms);
    });
  });
}

std::vector<Polynomial> parts_of(const Fraction& fraction) {
  std::vector<Polynomial> result{fraction.numerator()};
  for (const auto& [factor, exponent] : fraction.denominator()) result.push_back(factor);
  return result;
}

std::set<Variable> all_variables_within(const Polynomial& polynomial, const Atoms& atoms) {
  std::set<Variable> result;
  std::vector<Polynomial> open{polynomial};
  while (!open.empty()) {
    const std::set<Variable> found = open.back().variables();
    open.pop_back();
    for (const Variable v : found) {
      if (!result.insert(v).second) continue;
      for (const Fraction& argument : atoms[v].arguments)
        for (Polynomial& part : parts_of(argument)) open.push_back(std::move(part));
    }
  }
  return result;
}

std::set<Variable> free_running(const Polynomial& polynomial, const Atoms& atoms) {
  std::set<Variable> result;
  for (const Variable v : all_variables_within(polynomial, atoms))
    if (atoms[v].kind == Atom::Kind::running && depends(polynomial, {{v, {}, {}}}, atoms))
      result.insert(v);
  return result;
}

void require_plain(const Monomial& monomial, const Atoms& atoms) {
  require_plain(Fraction{Polynomial::from_terms({{monomial, 1}})}, atoms);
}

Conditions conditions_outside(const Conditions& conditions, const IntegrationRanges& ranges,
                              const Span& span, Workspace& w) {
  SignFacts facts;
  for (const IntegrationRange& range : ranges)
    if (const auto interval = interval_of(range)) {
      const Polynomial x = Polynomial::variable(range.variable);
      facts.add_interval(range.variable, *interval);
      facts.add_inequality(difference(x, Polynomial{interval->low}, w.budget), false);
      facts.add_inequality(difference(Polynomial{interval->high}, x, w.budget), false);
    }
  Conditions result;
  for (const Condition& condition : conditions) {
    const Polynomial& p = condition.polynomial;
    const bool not_zero = condition.kind == Condition::Kind::not_zero;
    if (!depends(p, ranges, w.atoms)) {
      result.insert(condition);
      continue;
    }
    if (not_zero ? facts.never_zero(p, w.budget) : facts.never_negative(p, w.budget)) continue;
    const std::string place = not_zero ? place_of_zero(p, ranges, w) : "";
    if (!place.empty()) throw NoValue{"the integrand has no value " + place, span};
    throw OutsideTheory{
        "the integral has a value only where " + to_text(Fraction{p}, w.atoms, w.budget, 200) +
        (not_zero ? " != 0" : " >= 0") + " for all values of its variables, which was not shown"};
  }
  return result;
}

}  // namespace patchproof
