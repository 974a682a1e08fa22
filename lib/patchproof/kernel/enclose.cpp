#include <patchproof/kernel/enclose.hpp>

#include <map>
#include <stdexcept>

namespace patchproof {

namespace {

class UnknownOccurs : public std::exception {};

// The enclosures of one precision; each atom is worked out once.
class Encloser {
 public:
  Encloser(const Atoms& atoms, unsigned bits, Budget& budget)
      : atoms_{atoms}, bits_{bits}, budget_{budget} {}

  Enclosure of(const Fraction& fraction) {
    Enclosure result = of(fraction.numerator());
    for (const auto& [factor, exponent] : fraction.denominator())
      result = result / power(of(factor), static_cast<long>(exponent));
    return result;
  }

 private:
  Enclosure of(const Polynomial& polynomial) {
    Enclosure total = exactly(0);
    for (const auto& term : polynomial.terms()) {
      budget_.spend(bits_);
      Enclosure part = exactly(term.coefficient);
      for (const auto& p : term.monomial.powers())
        part = part * power(of(p.variable), static_cast<long>(p.exponent));
      total = total + part;
    }
    // Products of long fractions would double in length at every level of nesting.
    return rounded(total, 2 * bits_);
  }

  const Enclosure& of(Variable variable) {
    const auto known = known_.find(variable);
    if (known != known_.end()) return known->second;
    return known_.emplace(variable, computed(variable)).first->second;
  }

  Enclosure computed(Variable variable) {
    budget_.spend(std::uint64_t{bits_} * bits_ / 4);
    const Atom& atom = atoms_[variable];
    switch (atom.kind) {
      case Atom::Kind::pi: return pi_enclosure(bits_);
      case Atom::Kind::sine: return sine(of(atom.arguments.front()), bits_);
      case Atom::Kind::cosine: return cosine(of(atom.arguments.front()), bits_);
      case Atom::Kind::exponential: return exponential(of(atom.arguments.front()), bits_);
      case Atom::Kind::root: return square_root(of(atom.arguments.front()), bits_);
      default: throw UnknownOccurs{};
    }
  }

  const Atoms& atoms_;
  unsigned bits_;
  Budget& budget_;
  std::map<Variable, Enclosure> known_;
};

}  // namespace

std::optional<Enclosure> enclosure(const Fraction& fraction, const Atoms& atoms, unsigned bits,
                                   Budget& budget) {
  try {
    return Encloser{atoms, bits, budget}.of(fraction);
  } catch (const UnknownOccurs&) {
    return std::nullopt;
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

std::optional<int> certain_sign(const Fraction& fraction, const Atoms& atoms, Budget& budget) {
  if (fraction.is_polynomial() && fraction.numerator().is_constant()) {
    const Rational value = fraction.numerator().constant();
    return value == 0 ? 0 : value < 0 ? -1 : 1;
  }
  for (unsigned bits = 64; bits <= 2048; bits *= 2) {
    const std::optional<Enclosure> found = enclosure(fraction, atoms, bits, budget);
    if (!found) continue;
    const std::optional<int> result = sign(*found);
    if (result) return result;
  }
  return std::nullopt;
}

}  // namespace patchproof
