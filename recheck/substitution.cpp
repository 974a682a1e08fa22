#include <recheck/calculus.hpp>

namespace recheck {

namespace {

/// One replacement; what an atom becomes is worked out once.
class Substitution {
 public:
  Substitution(const Images& images, Field& field) : field_{field} {
    for (const auto& [atom, image] : images) known_.emplace(atom, image);
  }

  Quotient of(const Quotient& a) {
    Quotient result = of(a.numerator);
    for (const auto& [factor, exponent] : a.denominator) {
      if (unchanged(factor)) {
        result = field_.product(result, Quotient{constant(1), {{factor, exponent}}});
        continue;
      }
      const Quotient inverse = field_.inverse(of(factor));
      for (unsigned k = 0; k < exponent; ++k) result = field_.product(result, inverse);
    }
    return result;
  }

 private:
  Quotient of(const Polynomial& a) {
    // Monomials with the same changing part are replaced together.
    std::map<Monomial, Polynomial, MonomialOrder> parts;
    for (const auto& [monomial, coefficient] : a) {
      Monomial changing;
      Monomial kept;
      for (const Power& power : monomial) (image(power.atom) ? changing : kept).push_back(power);
      field_.meter().spend(1 + monomial.size());
      add(parts[changing], kept, coefficient);
    }
    Quotient result;
    for (const auto& [changing, kept] : parts) {
      Quotient part = as_quotient(kept);
      for (const Power& power : changing) part = field_.product(part, power_of(power));
      result = field_.sum(result, part);
    }
    return result;
  }

  const Quotient& power_of(const Power& power) {
    const auto found = powers_.find(power);
    if (found != powers_.end()) return found->second;
    return powers_.emplace(power, field_.power(*image(power.atom), power.exponent)).first->second;
  }

  bool unchanged(const Polynomial& a) {
    for (const Atom atom : atoms_in(a))
      if (image(atom)) return false;
    return true;
  }

  /// Empty for an atom that stays what it is. The depth of recursion is that of the atom.
  const std::optional<Quotient>& image(Atom atom) {
    const auto known = known_.find(atom);
    if (known != known_.end()) return known->second;
    const Meaning meaning = field_.meaning(atom);
    std::optional<Quotient> result;
    std::vector<Quotient> arguments;
    bool changed = false;
    for (const Quotient& argument : meaning.arguments) {
      bool same = unchanged(argument.numerator);
      for (const auto& [factor, exponent] : argument.denominator) same = same && unchanged(factor);
      arguments.push_back(same ? argument : of(argument));
      changed = changed || !same;
    }
    if (changed)
      result = of_atom(field_.jet(meaning.symbol, meaning.index, meaning.orders, arguments));
    return known_.emplace(atom, std::move(result)).first->second;
  }

  Field& field_;
  std::map<Atom, std::optional<Quotient>> known_;
  std::map<Power, Quotient> powers_;
};

}  // namespace

Quotient substituted(const Quotient& a, const Images& images, Field& field) {
  return images.empty() ? a : Substitution{images, field}.of(a);
}

Polynomials substituted_divisors(const Polynomials& divisors, const Images& images, Field& field) {
  Polynomials result;
  for (const Polynomial& divisor : divisors) {
    const Polynomial moved = substituted(as_quotient(divisor), images, field).numerator;
    if (moved.empty()) throw Rejection{"division by zero"};
    if (!number_in(moved)) result.insert(field.monic(moved));
  }
  return result;
}

}  // namespace recheck
