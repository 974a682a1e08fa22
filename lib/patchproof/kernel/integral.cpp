#include <patchproof/kernel/integral.hpp>

#include <algorithm>
#include <numeric>

#include <patchproof/kernel/integration_variables.hpp>
#include <patchproof/kernel/transformation.hpp>

namespace patchproof {

namespace {

constexpr std::size_t most_permuted = 3;

class Integration {
 public:
  explicit Integration(Workspace& workspace) : w_{workspace} {}

  Fraction operator()(const Fraction& integrand, const IntegrationRanges& ranges) {
    if (ranges.empty() || integrand.is_zero()) return integrand;
    for (const auto& [factor, exponent] : integrand.denominator())
      if (depends(factor, ranges, w_.atoms))
        throw OutsideTheory{
            "the integral of a quotient whose divisor depends on a variable of the "
            "integral is not worked out in this version"};
    // What does not depend on the variables goes outside.
    std::map<Monomial, std::vector<Polynomial::Term>> parts;
    std::map<Variable, bool> is_inside;
    for (const Variable v : integrand.numerator().variables())
      is_inside.emplace(v, depends(Polynomial::variable(v), ranges, w_.atoms));
    for (const auto& term : integrand.numerator().terms()) {
      Monomial inside;
      Monomial outside;
      for (const auto& p : term.monomial.powers()) {
        Monomial& part = is_inside.at(p.variable) ? inside : outside;
        part = part * Monomial{p.variable, p.exponent};
      }
      parts[inside].push_back({outside, term.coefficient});
    }
    Fraction total;
    for (auto& [inside, terms] : parts) {
      w_.budget.spend(10);
      const Fraction value = of_monomial(inside, ranges);
      const Fraction outside = Polynomial::from_terms(std::move(terms));
      total = sum(total, product(value, outside, w_.budget), w_.budget);
    }
    const Fraction below{Polynomial{Rational{1}}, integrand.denominator(), w_.budget};
    return normal_form(product(total, below, w_.budget), w_);
  }

 private:
  // The atoms in the monomial that depend on the variable, other than the variable itself.
  std::vector<Monomial::Power> atoms_with(const Monomial& monomial, const IntegrationRange& range) {
    std::vector<Monomial::Power> result;
    for (const auto& p : monomial.powers()) {
      if (p.variable == range.variable) continue;
      if (depends(Polynomial::variable(p.variable), {range}, w_.atoms)) result.push_back(p);
    }
    return result;
  }

  Fraction of_monomial(const Monomial& monomial, const IntegrationRanges& ranges) {
    Fraction result{Rational{1}};
    Monomial rest = monomial;
    IntegrationRanges open;
    for (const IntegrationRange& range : ranges) {
      if (!atoms_with(monomial, range).empty()) {
        open.push_back(range);
        continue;
      }
      const long k = static_cast<long>(monomial.exponent(range.variable)) + 1;
      const Fraction upper = power(range.upper, k, w_.budget);
      const Fraction lower = power(range.lower, k, w_.budget);
      const Fraction value = difference(upper, lower, w_.budget);
      result = product(result, product(value, Rational{1, k}, w_.budget), w_.budget);
      rest = rest.without(range.variable);
    }
    // Factors with no variable in common are integrated one by one (Fubini).
    while (!open.empty()) {
      IntegrationRanges together{open.front()};
      open.erase(open.begin());
      Monomial part;
      for (std::size_t k = 0; k < together.size(); ++k) {
        for (const Monomial::Power& p : atoms_with(rest, together[k])) {
          for (auto other = open.begin(); other != open.end();) {
            const bool meets = depends(Polynomial::variable(p.variable), {*other}, w_.atoms);
            if (meets) together.push_back(*other);
            other = meets ? open.erase(other) : other + 1;
          }
        }
      }
      for (const auto& p : rest.powers())
        if (depends(Polynomial::variable(p.variable), together, w_.atoms))
          part = part * Monomial{p.variable, p.exponent};
      result = product(result, of_connected(part, together), w_.budget);
    }
    return result;
  }

  Fraction of_connected(const Monomial& monomial, const IntegrationRanges& ranges) {
    w_.budget.spend(20);
    require_plain(monomial, w_.atoms);
    for (const IntegrationRange& range : ranges) {
      const std::vector<Monomial::Power> factors = atoms_with(monomial, range);
      if (factors.size() != 1 || factors.front().exponent != 1) continue;
      if (const auto part = integrable(factors.front().variable, range))
        return by_parts(monomial, *part, range, ranges);
    }
    for (const IntegrationRange& range : ranges)
      if (const auto part = to_be_moved(monomial, range))
        return by_parts(monomial, *part, range, ranges);
    return opaque(monomial, ranges);
  }

  // A factor that is a derivative in a variable of the integral: slope * d/dx of `antiderivative`.
  struct Integrable {
    Variable factor;
    Variable antiderivative;
    Rational slope;
  };

  // F_v(u, 2*v + 1) in v: one argument alone depends on the variable, and linearly.
  std::optional<Integrable> integrable(Variable factor, const IntegrationRange& range) {
    const std::optional<std::size_t> place = running_argument(factor, range);
    if (!place) return std::nullopt;
    Atom lowered = w_.atoms[factor];
    if (lowered.orders[*place] == 0) return std::nullopt;
    --lowered.orders[*place];
    const Polynomial& argument = lowered.arguments[*place].numerator();
    const Rational slope = coefficients(argument, range.variable)[1].constant();
    return Integrable{factor, w_.atoms.variable(lowered), slope};
  }

  std::optional<std::size_t> running_argument(Variable factor, const IntegrationRange& range) {
    const Atom& atom = w_.atoms[factor];
    if (atom.kind != Atom::Kind::jet) return std::nullopt;
    std::optional<std::size_t> place;
    for (std::size_t k = 0; k < atom.arguments.size(); ++k) {
      const Fraction& argument = atom.arguments[k];
      if (!depends(argument.numerator(), {range}, w_.atoms)) continue;
      if (place || argument.numerator().degree(range.variable) != 1) return std::nullopt;
      const std::vector<Polynomial> parts = coefficients(argument.numerator(), range.variable);
      if (!parts[1].is_constant() || depends(parts[0], {range}, w_.atoms)) return std::nullopt;
      place = k;
    }
    return place;
  }

  // Of a product of two functions the one declared later gives its derivatives to the other, as
  // long as that one has enough of them: so both sides of an integration by parts look the same.
  std::optional<Integrable> to_be_moved(const Monomial& monomial, const IntegrationRange& range) {
    std::vector<Monomial::Power> factors = atoms_with(monomial, range);
    if (factors.size() != 2 || factors[0].exponent != 1 || factors[1].exponent != 1)
      return std::nullopt;
    for (const auto& p : factors)
      if (!running_argument(p.variable, range)) return std::nullopt;
    const auto ordinal = [&](const Monomial::Power& p) {
      return w_.atoms[p.variable].symbol->ordinal;
    };
    if (ordinal(factors[0]) == ordinal(factors[1])) return std::nullopt;
    if (ordinal(factors[1]) < ordinal(factors[0])) std::swap(factors[0], factors[1]);
    const Atom& earlier = w_.atoms[factors[0].variable];
    const int order = std::accumulate(earlier.orders.begin(), earlier.orders.end(), 0);
    if (order >= earlier.symbol->smoothness) return std::nullopt;
    return integrable(factors[1].variable, range);
  }

  // The integral of g * slope * F' is the difference of g * F at the ends less that of g' * F.
  Fraction by_parts(const Monomial& monomial, const Integrable& part, const IntegrationRange& range,
                    const IntegrationRanges& ranges) {
    const Fraction rest = product_of(monomial.without(part.factor));
    const Fraction antiderivative = Polynomial::variable(part.antiderivative);
    const Fraction whole = product(rest, antiderivative, w_.budget);
    Substitution upper{{{range.variable, range.upper}}, w_};
    Substitution lower{{{range.variable, range.lower}}, w_};
    const Fraction ends = difference(upper(whole), lower(whole), w_.budget);
    IntegrationRanges others;
    for (const IntegrationRange& other : ranges)
      if (other.variable != range.variable) others.push_back(other);
    Conditions none;
    const Fraction slope = derivative(rest, range.variable, none, w_);
    const Fraction left = (*this)(product(slope, antiderivative, w_.budget), ranges);
    const Fraction result = difference((*this)(ends, others), left, w_.budget);
    return product(result, Rational{1} / part.slope, w_.budget);
  }

  static Fraction product_of(const Monomial& monomial) {
    return Polynomial::from_terms({{monomial, 1}});
  }

  // Variables are renamed, and put into the order that makes the least atom, so that equal
  // integrals are one atom.
  Fraction opaque(const Monomial& monomial, const IntegrationRanges& ranges) {
    std::vector<std::size_t> order(ranges.size());
    std::iota(order.begin(), order.end(), 0);
    std::optional<Atom> least;
    do {
      w_.budget.spend(20);
      Atom atom{Atom::Kind::integral, nullptr, 0, {}, {Fraction{}}};
      std::map<Variable, Fraction> images;
      for (std::size_t k = 0; k < order.size(); ++k) {
        const IntegrationRange& range = ranges[order[k]];
        if (difference(range.upper, range.lower, w_.budget).is_zero()) return {};
        const Atom running{
            Atom::Kind::running, nullptr, static_cast<int>(k), {}, {range.lower, range.upper}};
        atom.arguments.emplace_back(Polynomial::variable(w_.atoms.variable(running)));
        images.emplace(range.variable, atom.arguments.back());
      }
      atom.arguments.front() = Substitution{std::move(images), w_}(product_of(monomial));
      if (!least || atom < *least) least = std::move(atom);
    } while (ranges.size() <= most_permuted && std::next_permutation(order.begin(), order.end()));
    return Polynomial::variable(w_.atoms.variable(*least));
  }

  Workspace& w_;
};

}  // namespace

Fraction integral(const Fraction& integrand, const IntegrationRanges& ranges,
                  Workspace& workspace) {
  return Integration{workspace}(integrand, ranges);
}

IntegrationRanges ranges_of(const Atom& integral, const Atoms& atoms) {
  IntegrationRanges result;
  for (std::size_t k = 1; k < integral.arguments.size(); ++k) {
    const Variable running = *variables(integral.arguments[k]).begin();
    const std::vector<Fraction>& ends = atoms[running].arguments;
    result.push_back({running, ends.at(0), ends.at(1)});
  }
  return result;
}

Fraction renewed_integral(const Atom& atom, Workspace& workspace) {
  const IntegrationRanges ranges = ranges_of(atom, workspace.atoms);
  return integral(atom.arguments.front(), ranges, workspace);
}

}  // namespace patchproof
