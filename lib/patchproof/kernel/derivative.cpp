#include <numeric>

#include <patchproof/kernel/integral.hpp>
#include <patchproof/kernel/transformation.hpp>

namespace patchproof {

namespace {

class Derivation {
 public:
  Derivation(Variable variable, Conditions& conditions, Workspace& workspace)
      : variable_{variable}, conditions_{conditions}, w_{workspace} {}

  Fraction operator()(const Fraction& fraction) {
    Fraction result = of_polynomial(fraction.numerator());
    const Fraction whole{Polynomial{Rational{1}}, fraction.denominator(), w_.budget};
    result = product(result, whole, w_.budget);
    // (N / prod F^e)' = N' / prod F^e - N / prod F^e * sum e F'/F
    for (const auto& [factor, exponent] : fraction.denominator()) {
      const Fraction relative = quotient(of_polynomial(factor), Fraction{factor}, w_.budget);
      const Fraction part =
          product(product(fraction, relative, w_.budget), Rational{exponent}, w_.budget);
      result = difference(result, part, w_.budget);
    }
    return normal_form(result, w_);
  }

 private:
  Fraction of_polynomial(const Polynomial& polynomial) {
    Fraction result;
    for (const Variable v : polynomial.variables()) {
      const Fraction inner = of_variable(v);
      if (inner.is_zero()) continue;
      result = sum(result, product(patchproof::derivative(polynomial, v), inner, w_.budget),
                   w_.budget);
    }
    return result;
  }

  const Fraction& of_variable(Variable v) {
    const auto known = known_.find(v);
    if (known != known_.end()) return known->second;
    Fraction result = v == variable_ ? Fraction{Rational{1}} : of_atom(v, w_.atoms[v]);
    return known_.emplace(v, std::move(result)).first->second;
  }

  Fraction of_atom(Variable v, const Atom atom) {
    if (atom.arguments.empty()) return {};
    if (atom.kind == Atom::Kind::jet) return of_jet(atom);
    if (atom.kind == Atom::Kind::running) return {};
    if (atom.kind == Atom::Kind::integral) return of_integral(atom);
    const Fraction inner = (*this)(atom.arguments.front());
    if (inner.is_zero()) return {};
    const Fraction self = Polynomial::variable(v);
    switch (atom.kind) {
      case Atom::Kind::sine: return product(partner(atom, Atom::Kind::cosine), inner, w_.budget);
      case Atom::Kind::cosine:
        return product(product(partner(atom, Atom::Kind::sine), inner, w_.budget), Rational{-1},
                       w_.budget);
      case Atom::Kind::root:
        // sqrt(a)' = a' sqrt(a) / (2a): the root has no derivative where a = 0.
        conditions_.insert({Condition::Kind::not_zero, atom.arguments.front().numerator()});
        return quotient(product(self, inner, w_.budget),
                        product(atom.arguments.front(), Rational{2}, w_.budget), w_.budget);
      default: return product(self, inner, w_.budget);
    }
  }

  Fraction of_jet(const Atom& atom) {
    Fraction result;
    for (std::size_t k = 0; k < atom.arguments.size(); ++k) {
      const Fraction inner = (*this)(atom.arguments[k]);
      if (inner.is_zero()) continue;
      Atom raised = atom;
      ++raised.orders[k];
      const int total = std::accumulate(raised.orders.begin(), raised.orders.end(), 0);
      const Symbol& function = *atom.symbol;
      if (total > function.smoothness)
        throw std::domain_error{"a derivative of order " + std::to_string(total) + " of '" +
                                function.name + "', which is only assumed C^" +
                                std::to_string(function.smoothness)};
      result = sum(result,
                   product(Polynomial::variable(w_.atoms.variable(raised)), inner, w_.budget),
                   w_.budget);
    }
    return result;
  }

  // Leibniz: under the integral, and at the ends that move.
  Fraction of_integral(const Atom& atom) {
    const Fraction& integrand = atom.arguments.front();
    const IntegrationRanges ranges = ranges_of(atom, w_.atoms);
    Fraction result = integral((*this)(integrand), ranges, w_);
    for (std::size_t k = 0; k < ranges.size(); ++k) {
      IntegrationRanges others = ranges;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      for (const bool upper : {true, false}) {
        const Fraction& end = upper ? ranges[k].upper : ranges[k].lower;
        const Fraction speed = (*this)(end);
        if (speed.is_zero()) continue;
        const Fraction there = Substitution{{{ranges[k].variable, end}}, w_}(integrand);
        const Fraction moved = product(integral(there, others, w_), speed, w_.budget);
        result = upper ? sum(result, moved, w_.budget) : difference(result, moved, w_.budget);
      }
    }
    return result;
  }

  Fraction partner(const Atom& atom, Atom::Kind kind) {
    return Polynomial::variable(w_.atoms.variable({kind, nullptr, 0, {}, atom.arguments}));
  }

  Variable variable_;
  Conditions& conditions_;
  Workspace& w_;
  std::map<Variable, Fraction> known_;
};

}  // namespace

Fraction derivative(const Fraction& fraction, Variable variable, Conditions& conditions,
                    Workspace& workspace) {
  return Derivation{variable, conditions, workspace}(fraction);
}

}  // namespace patchproof
