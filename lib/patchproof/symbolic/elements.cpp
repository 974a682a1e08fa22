#include <patchproof/symbolic/elements.hpp>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>

#include <patchproof/symbolic/exact_number.hpp>
#include <patchproof/symbolic/normal_form.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;
using Kind = Atom::Kind;

constexpr int highest_derivative = 4096;

Summand leading_summand(const ex& polynomial, const Atoms& atoms) {
  const std::vector<Summand> all = summands(polynomial, atoms);
  return *std::max_element(all.begin(), all.end(), [](const Summand& a, const Summand& b) {
    return is_larger(b.powers, a.powers);
  });
}

// The largest monomial that divides all summands; exponents may be negative.
Powers common_monomial(const ex& polynomial, const Atoms& atoms) {
  const std::vector<Summand> all = summands(polynomial, atoms);
  std::set<unsigned> ids;
  for (const Summand& part : all) {
    for (const auto& [id, exponent] : part.powers) ids.insert(id);
  }
  Powers result;
  for (const unsigned id : ids) {
    long lowest = exponent_of(all.front().powers, id);
    for (const Summand& part : all) lowest = std::min(lowest, exponent_of(part.powers, id));
    if (lowest != 0) result.emplace_back(id, lowest);
  }
  return result;
}

ex inverse_of_monomial(Ring& ring, const Powers& powers) {
  ex result = 1;
  for (const auto& [id, exponent] : powers) {
    const Atom& atom = ring.atoms().at(id);
    ex factor;
    if (atom.kind == Kind::root) {
      const ex radicand = atom.arguments.front();
      factor = ring.product(ring.atoms().symbol(id), inverse(ring, radicand));
    } else if (atom.kind == Kind::inverse) {
      factor = ring.power(atom.arguments.front(), static_cast<unsigned long>(exponent));
    } else {
      factor = GiNaC::pow(ring.atoms().symbol(id), numeric{-exponent});
    }
    result = ring.product(result, factor);
  }
  return result;
}

// Whether m is a multiple of divisor*atom in exponents that do not become negative.
bool is_divisible(const Powers& m, const Powers& divisor, unsigned atom) {
  return exponent_of(m, atom) > 0 &&
         std::all_of(divisor.begin(), divisor.end(), [&](const auto& power) {
           return exponent_of(m, power.first) >= power.second;
         });
}

// For i = 1/d and d = m + rest, m the leading monomial: m*i becomes 1 - rest*i.
ex with_one_denominator_cancelled(Ring& ring, ex polynomial, unsigned id) {
  const ex denominator = ring.atoms().at(id).arguments.front();
  const Powers leading = leading_summand(denominator, ring.atoms()).powers;
  const ex replaced = monomial(leading, ring.atoms()) * ring.atoms().symbol(id);
  const ex rest = denominator - monomial(leading, ring.atoms());
  const ex replacement = 1 - ring.product(rest, ring.atoms().symbol(id));
  for (;;) {
    GiNaC::exvector quotient;
    GiNaC::exvector others;
    for (const Summand& part : summands(polynomial, ring.atoms())) {
      const ex whole = part.coefficient * monomial(part.powers, ring.atoms());
      if (is_divisible(part.powers, leading, id)) {
        quotient.push_back(whole / replaced);
      } else {
        others.push_back(whole);
      }
    }
    if (quotient.empty()) return polynomial;
    polynomial = ring.sum({sum(others), ring.product(sum(quotient), replacement)});
  }
}

ex with_denominators_cancelled(Ring& ring, ex polynomial) {
  const std::set<unsigned> ids = ring.atoms().occurring(polynomial);
  for (auto id = ids.rbegin(); id != ids.rend(); ++id) {
    if (ring.atoms().at(*id).kind == Kind::inverse) {
      polynomial = with_one_denominator_cancelled(ring, polynomial, *id);
    }
  }
  return polynomial;
}

bool has_relations(const Ring& ring, const ex& polynomial) {
  const std::set<unsigned> ids = ring.atoms().occurring(polynomial);
  return std::any_of(ids.begin(), ids.end(), [&](unsigned id) {
    const Kind kind = ring.atoms().at(id).kind;
    return kind == Kind::inverse || kind == Kind::exponential || kind == Kind::root;
  });
}

ex root_of_number(Ring& ring, const numeric& number) {
  if (number.is_zero()) return 0;
  const SquareRoot root = square_root(number);
  ex result = root.outside;
  for (const Radical& radical : root.inside) {
    Atom atom;
    atom.kind = Kind::root;
    atom.arguments = {radical.radicand};
    atom.prime = radical.prime;
    result = ring.product(result, ring.atoms().symbol_for(atom));
  }
  return result;
}

// The positive greatest common divisor of the coefficients; 1 if one of them is not real.
numeric content(const ex& polynomial, const Atoms& atoms) {
  numeric top = 0;
  numeric bottom = 1;
  for (const Summand& part : summands(polynomial, atoms)) {
    if (!part.coefficient.is_rational()) return 1;
    top = GiNaC::gcd(top, part.coefficient.numer());
    bottom = GiNaC::lcm(bottom, part.coefficient.denom());
  }
  return GiNaC::abs(top) / bottom;
}

}  // namespace

ex letter(Ring& ring, const SymbolPointer& symbol, int component) {
  Atom atom;
  atom.symbol = symbol;
  atom.component = component;
  return ring.atoms().symbol_for(atom);
}

ex placeholder(Ring& ring, int position) {
  Atom atom;
  atom.kind = Kind::placeholder;
  atom.component = position;
  return ring.atoms().symbol_for(atom);
}

ex jet(Ring& ring, const SymbolPointer& function, int component, const Indices& orders,
       const GiNaC::exvector& arguments) {
  for (const int order : orders) {
    if (order > highest_derivative) throw OverBudget{"a derivative of too high an order"};
  }
  Atom atom;
  atom.kind = Kind::jet;
  atom.symbol = function;
  atom.component = component;
  atom.orders = orders;
  for (const ex& argument : arguments) {
    atom.arguments.push_back(canonical_argument(ring, argument));
  }
  return ring.atoms().symbol_for(atom);
}

ex pi(Ring& ring) {
  Atom atom;
  atom.kind = Kind::pi;
  return ring.atoms().symbol_for(atom);
}

ex inverse(Ring& ring, const ex& denominator) {
  if (is_zero(ring, denominator)) {
    throw std::domain_error{"a denominator that is zero identically"};
  }
  const Powers common = common_monomial(denominator, ring.atoms());
  const ex outside = inverse_of_monomial(ring, common);
  const ex rest = ring.product(denominator, outside);
  if (is_a<numeric>(rest)) return outside / rest;
  const numeric leading = leading_summand(rest, ring.atoms()).coefficient;
  Atom atom;
  atom.kind = Kind::inverse;
  atom.arguments = {rest / leading};
  return ring.product(outside / leading, ring.atoms().symbol_for(atom));
}

ex whole_power(Ring& ring, const ex& base, long exponent) {
  if (exponent >= 0) return ring.power(base, static_cast<unsigned long>(exponent));
  return ring.power(inverse(ring, base), 0UL - static_cast<unsigned long>(exponent));
}

ex square_root(Ring& ring, const ex& radicand) {
  if (is_a<numeric>(radicand)) return root_of_number(ring, ex_to<numeric>(radicand));
  const ex canonical = canonical_argument(ring, radicand);
  if (is_a<numeric>(canonical)) return root_of_number(ring, ex_to<numeric>(canonical));
  const numeric factor = content(canonical, ring.atoms());
  Atom atom;
  atom.kind = Kind::root;
  atom.arguments = {canonical / factor};
  return ring.product(root_of_number(ring, factor), ring.atoms().symbol_for(atom));
}

ex canonical_argument(Ring& ring, const ex& argument) {
  const ex cancelled = with_denominators_cancelled(ring, argument);
  const bool related = has_relations(ring, cancelled);
  if (related && is_zero(ring, cancelled)) return 0;
  // Arguments without relations between their atoms are equal only if they look so.
  for (unsigned id = 0; id < ring.atoms().size(); ++id) {
    if (!related && !ring.atoms().is_related(id)) continue;
    const GiNaC::exvector others = ring.atoms().at(id).arguments;
    for (const ex& other : others) {
      ring.spend(1);
      if (other.is_equal(cancelled)) return other;
      if (is_zero(ring, ring.sum({cancelled, -other}))) return other;
    }
  }
  return cancelled;
}

}  // namespace patchproof::symbolic
