#include <patchproof/figure/enclosure_at.hpp>

#include <stdexcept>

#include <patchproof/kernel/readable.hpp>
#include <patchproof/kernel/workspace.hpp>

namespace patchproof {

namespace {

class Encloser {
 public:
  Encloser(const std::map<Variable, Rational>& at, const Atoms& atoms, unsigned bits,
           Budget& budget)
      : at_{at}, atoms_{atoms}, bits_{bits}, budget_{budget} {}

  Enclosure of(const Fraction& fraction) const {
    Enclosure result = of(fraction.numerator());
    for (const auto& [factor, exponent] : fraction.denominator())
      result = result / power(of(factor), static_cast<long>(exponent));
    return result;
  }

 private:
  Enclosure of(const Polynomial& polynomial) const {
    Enclosure total = exactly(0);
    for (const auto& term : polynomial.terms()) {
      budget_.spend(bits_);
      Enclosure part = exactly(term.coefficient);
      for (const auto& p : term.monomial.powers())
        part = part * power(of(p.variable), static_cast<long>(p.exponent));
      total = total + part;
    }
    return rounded(total, 2 * bits_);
  }

  Enclosure of(Variable variable) const {
    if (const auto known = at_.find(variable); known != at_.end()) return exactly(known->second);
    budget_.spend(std::uint64_t{bits_} * bits_ / 4);
    const Atom& atom = atoms_[variable];
    switch (atom.kind) {
      case Atom::Kind::pi:
        return pi_enclosure(bits_);
      case Atom::Kind::sine:
        return sine(of(atom.arguments.front()), bits_);
      case Atom::Kind::cosine:
        return cosine(of(atom.arguments.front()), bits_);
      case Atom::Kind::exponential:
        return exponential(of(atom.arguments.front()), bits_);
      case Atom::Kind::root:
        return square_root(of(atom.arguments.front()), bits_);
      default:
        throw OutsideTheory{"nothing is known of " + to_text(variable, atoms_)};
    }
  }

  const std::map<Variable, Rational>& at_;
  const Atoms& atoms_;
  unsigned bits_;
  Budget& budget_;
};

}  // namespace

std::optional<Enclosure> enclosure_at(const Fraction& fraction,
                                      const std::map<Variable, Rational>& at, const Atoms& atoms,
                                      unsigned bits, Budget& budget) {
  try {
    return Encloser{at, atoms, bits, budget}.of(fraction);
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

}  // namespace patchproof
