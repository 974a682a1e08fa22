#include <patchproof/symbolic/derivation.hpp>

#include <map>

#include <patchproof/symbolic/elements.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::numeric;
using Kind = Atom::Kind;

// The derivation by one variable.
class Derivation {
 public:
  Derivation(Ring& ring, unsigned variable) : ring_{ring}, variable_{variable} {}

  ex operator()(const ex& polynomial) {
    GiNaC::exvector parts;
    for (const unsigned id : ring_.atoms().occurring(polynomial)) {
      if (!ring_.atoms().within(id).contains(variable_)) continue;
      ring_.spend(1 + term_count(polynomial));
      const GiNaC::symbol symbol = GiNaC::ex_to<GiNaC::symbol>(ring_.atoms().symbol(id));
      parts.push_back(ring_.product(polynomial.diff(symbol).expand(), of_atom(id)));
    }
    return ring_.sum(parts);
  }

 private:
  ex of_atom(unsigned id) {
    if (id == variable_) return 1;
    const auto known = known_.find(id);
    if (known != known_.end()) return known->second;
    const ex result = new_derivative(id);
    known_.emplace(id, result);
    return result;
  }

  ex new_derivative(unsigned id) {
    const Atom& atom = ring_.atoms().at(id);
    const ex& symbol = ring_.atoms().symbol(id);
    switch (atom.kind) {
      case Kind::jet:
        return of_jet(atom);
      case Kind::inverse:
        return ring_.product(-ring_.power(symbol, 2), (*this)(atom.arguments.front()));
      case Kind::root: {
        // r'/(2*s), with 1/s = s/r
        const ex radicand = atom.arguments.front();
        const ex change = ring_.product((*this)(radicand), symbol / 2);
        return ring_.product(change, inverse(ring_, radicand));
      }
      case Kind::exponential: {
        const ex unit = atom.imaginary ? ex{GiNaC::I} : ex{1};
        const ex rate = ring_.product((*this)(atom.arguments.front()), unit / atom.divisor);
        return ring_.product(rate, symbol);
      }
      case Kind::letter:
      case Kind::placeholder:
      case Kind::pi:
        break;
    }
    return 0;
  }

  ex of_jet(const Atom& atom) {
    GiNaC::exvector parts;
    for (std::size_t i = 0; i < atom.arguments.size(); ++i) {
      const ex rate = (*this)(atom.arguments[i]);
      if (rate.is_zero()) continue;
      Indices orders = atom.orders;
      ++orders[i];
      parts.push_back(
          ring_.product(rate, jet(ring_, atom.symbol, atom.component, orders, atom.arguments)));
    }
    return ring_.sum(parts);
  }

  Ring& ring_;
  unsigned variable_;
  std::map<unsigned, ex> known_;
};

}  // namespace

ex derivative(Ring& ring, const ex& polynomial, unsigned variable, int order) {
  Derivation derivation{ring, variable};
  ex result = polynomial;
  for (int k = 0; k < order && !result.is_zero(); ++k) result = derivation(result);
  return result;
}

}  // namespace patchproof::symbolic
