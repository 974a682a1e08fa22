#include <patchproof/kernel/enclose.hpp>

#include <stdexcept>

namespace patchproof {

namespace {

class UnknownOccurs : public std::exception {};

Enclosure of_fraction(const Fraction& fraction, const Atoms& atoms, unsigned bits);

Enclosure of_variable(Variable variable, const Atoms& atoms, unsigned bits) {
  const Atom& atom = atoms[variable];
  switch (atom.kind) {
    case Atom::Kind::pi: return pi_enclosure(bits);
    case Atom::Kind::sine: return sine(of_fraction(atom.arguments.front(), atoms, bits), bits);
    case Atom::Kind::cosine: return cosine(of_fraction(atom.arguments.front(), atoms, bits), bits);
    case Atom::Kind::exponential:
      return exponential(of_fraction(atom.arguments.front(), atoms, bits), bits);
    case Atom::Kind::root:
      return square_root(of_fraction(atom.arguments.front(), atoms, bits), bits);
    default: throw UnknownOccurs{};
  }
}

Enclosure of_polynomial(const Polynomial& polynomial, const Atoms& atoms, unsigned bits) {
  Enclosure total = exactly(0);
  for (const auto& term : polynomial.terms()) {
    Enclosure part = exactly(term.coefficient);
    for (const auto& p : term.monomial.powers())
      part = part * power(of_variable(p.variable, atoms, bits), static_cast<long>(p.exponent));
    total = total + part;
  }
  return total;
}

Enclosure of_fraction(const Fraction& fraction, const Atoms& atoms, unsigned bits) {
  Enclosure result = of_polynomial(fraction.numerator(), atoms, bits);
  for (const auto& [factor, exponent] : fraction.denominator())
    result = result / power(of_polynomial(factor, atoms, bits), static_cast<long>(exponent));
  return result;
}

}  // namespace

std::optional<Enclosure> enclosure(const Fraction& fraction, const Atoms& atoms, unsigned bits) {
  try {
    return of_fraction(fraction, atoms, bits);
  } catch (const UnknownOccurs&) {
    return std::nullopt;
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

std::optional<int> certain_sign(const Fraction& fraction, const Atoms& atoms) {
  if (fraction.is_polynomial() && fraction.numerator().is_constant()) {
    const Rational value = fraction.numerator().constant();
    return value == 0 ? 0 : value < 0 ? -1 : 1;
  }
  for (unsigned bits = 64; bits <= 2048; bits *= 2) {
    const std::optional<Enclosure> found = enclosure(fraction, atoms, bits);
    if (!found) continue;
    const std::optional<int> result = sign(*found);
    if (result) return result;
  }
  return std::nullopt;
}

}  // namespace patchproof
