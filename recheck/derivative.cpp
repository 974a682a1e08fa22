#include <recheck/calculus.hpp>

namespace recheck {

namespace {

class Derivation {
 public:
  Derivation(Atom in, Field& field) : in_{in}, field_{field} {}

  Quotient of(const Quotient& a) {
    const Quotient below{constant(1), a.denominator};
    Quotient result = field_.product(of(a.numerator), below);
    // (N / prod F^e)' = N' / prod F^e - N / prod F^e * sum e F'/F
    for (const auto& [factor, exponent] : a.denominator) {
      const Quotient inner = of(factor);
      if (inner.numerator.empty()) continue;
      const Quotient relative = field_.product(inner, Quotient{constant(exponent), {{factor, 1}}});
      result = field_.difference(result, field_.product(a, relative));
    }
    return result;
  }

 private:
  Quotient of(const Polynomial& a) {
    Quotient result;
    for (const Atom atom : atoms_in(a)) {
      const Quotient inner = of_single(atom);
      if (inner.numerator.empty()) continue;
      const Quotient outer = as_quotient(partial_derivative(a, atom, field_.meter()));
      result = field_.sum(result, field_.product(outer, inner));
    }
    return result;
  }

  const Quotient& of_single(Atom atom) {
    const auto known = known_.find(atom);
    if (known != known_.end()) return known->second;
    Quotient result = atom == in_ ? number(1) : of_jet(field_.meaning(atom));
    return known_.emplace(atom, std::move(result)).first->second;
  }

  // The chain rule. By value: new atoms may move the meanings of the others.
  Quotient of_jet(const Meaning meaning) {
    Quotient result;
    for (std::size_t k = 0; k < meaning.arguments.size(); ++k) {
      const Quotient inner = of(meaning.arguments[k]);
      if (inner.numerator.empty()) continue;
      std::vector<std::size_t> orders = meaning.orders;
      ++orders[k];
      const Atom raised = field_.jet(meaning.symbol, meaning.index, orders, meaning.arguments);
      result = field_.sum(result, field_.product(of_atom(raised), inner));
    }
    return result;
  }

  Atom in_;
  Field& field_;
  std::map<Atom, Quotient> known_;
};

}  // namespace

Quotient derivative(const Quotient& a, Atom in, Field& field) {
  return Derivation{in, field}.of(a);
}

}  // namespace recheck
