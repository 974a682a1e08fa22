#include <patchproof/symbolic/normal_form.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include <patchproof/symbolic/cyclotomic.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::numeric;
using Kind = Atom::Kind;

constexpr long largest_exponent = 1'000'000;
// Each root that is eliminated doubles the degree.
constexpr int most_roots = 8;

std::optional<unsigned> last_of_kind(const Ring& ring, const ex& polynomial, Kind kind) {
  const std::set<unsigned> ids = ring.atoms().occurring(polynomial);
  const auto found = std::find_if(ids.rbegin(), ids.rend(), [&](unsigned id) {
    return ring.atoms().at(id).kind == kind && !ring.atoms().at(id).prime;
  });
  if (found == ids.rend()) return std::nullopt;
  return *found;
}

std::map<Powers, ex> coefficients_in(const Ring& ring, const ex& polynomial, unsigned atom) {
  return coefficients(polynomial, ring.atoms(), [atom](unsigned id) { return id == atom; });
}

// The denominator of an inverse has only older atoms, so the newest inverse goes first.
ex without_inverses(Ring& ring, ex polynomial) {
  while (const std::optional<unsigned> id = last_of_kind(ring, polynomial, Kind::inverse)) {
    const ex denominator = ring.atoms().at(*id).arguments.front();
    const std::map<Powers, ex> parts = coefficients_in(ring, polynomial, *id);
    long highest = 0;
    for (const auto& [powers, part] : parts) {
      highest = std::max(highest, exponent_of(powers, *id));
    }
    GiNaC::exvector cleared;
    for (const auto& [powers, part] : parts) {
      const auto missing = static_cast<unsigned long>(highest - exponent_of(powers, *id));
      cleared.push_back(ring.product(part, ring.power(denominator, missing)));
    }
    polynomial = ring.sum(cleared);
  }
  return polynomial;
}

struct Base {
  unsigned id;
  long multiple;
};

// exp(m/2) and exp(m/3) as powers of exp(m/6), for every monomial m.
std::map<unsigned, Base> common_bases(Ring& ring, const ex& polynomial) {
  std::vector<std::vector<unsigned>> families;
  for (const unsigned id : ring.atoms().occurring(polynomial)) {
    const Atom& atom = ring.atoms().at(id);
    if (atom.kind != Kind::exponential) continue;
    const auto family = std::find_if(families.begin(), families.end(), [&](const auto& members) {
      const Atom& other = ring.atoms().at(members.front());
      return other.imaginary == atom.imaginary &&
             other.arguments.front().is_equal(atom.arguments.front());
    });
    if (family == families.end()) {
      families.push_back({id});
    } else {
      family->push_back(id);
    }
  }
  std::map<unsigned, Base> result;
  for (const std::vector<unsigned>& members : families) {
    if (members.size() < 2) continue;
    Atom base = ring.atoms().at(members.front());
    for (const unsigned id : members) base.divisor = lcm(base.divisor, ring.atoms().at(id).divisor);
    const unsigned base_id = ring.atoms().id_of(ring.atoms().symbol_for(base));
    for (const unsigned id : members) {
      const numeric multiple = base.divisor / ring.atoms().at(id).divisor;
      if (multiple > numeric{largest_exponent}) throw OverBudget{"an exponent above a million"};
      result[id] = {base_id, multiple.to_long()};
    }
  }
  return result;
}

ex with_common_exponentials(Ring& ring, const ex& input) {
  const std::map<unsigned, Base> bases = common_bases(ring, input);
  if (bases.empty()) return input;
  std::vector<Summand> parts = summands(input, ring.atoms());
  for (Summand& part : parts) {
    std::map<unsigned, long> powers;
    for (const auto& [id, exponent] : part.powers) {
      const auto base = bases.find(id);
      const Base target = base == bases.end() ? Base{id, 1} : base->second;
      if (std::labs(exponent) > largest_exponent) throw OverBudget{"an exponent above a million"};
      powers[target.id] += exponent * target.multiple;
    }
    std::erase_if(powers, [](const auto& power) { return power.second == 0; });
    part.powers.assign(powers.begin(), powers.end());
  }
  return polynomial(parts, ring.atoms());
}

bool is_root_of_unity(const Ring& ring, const Atom& atom) {
  if (atom.kind != Kind::exponential || !atom.imaginary) return false;
  const ex& argument = atom.arguments.front();
  return GiNaC::is_a<GiNaC::symbol>(argument) &&
         ring.atoms().at(ring.atoms().id_of(argument)).kind == Kind::pi;
}

bool is_in_small_field(const Atom& root_of_unity) {
  return root_of_unity.divisor <= numeric{highest_order} &&
         field_order(root_of_unity.divisor.to_long()) <= highest_order;
}

ex with_reduced_roots_of_unity(Ring& ring, const ex& polynomial) {
  for (const unsigned id : ring.atoms().occurring(polynomial)) {
    const Atom& atom = ring.atoms().at(id);
    if (!is_root_of_unity(ring, atom) || !is_in_small_field(atom)) continue;
    ring.spend(static_cast<std::uint64_t>(highest_order) * highest_order);
    return in_cyclotomic_basis(polynomial, {id, atom.divisor.to_long()}, ring.atoms());
  }
  return polynomial;
}

// What an atom and its arguments are made of.
struct Contents {
  bool variables = false;
  bool pi = false;
  bool inverses = false;
  bool other = false;
};

Contents contents(const Ring& ring, unsigned atom) {
  Contents result;
  for (const unsigned id : ring.atoms().within(atom)) {
    if (id == atom) continue;
    const Atom& inner = ring.atoms().at(id);
    switch (inner.kind) {
      case Kind::letter:
      case Kind::placeholder:
      case Kind::jet:
        result.variables = true;
        break;
      case Kind::pi:
        result.pi = true;
        break;
      case Kind::inverse:
        result.inverses = true;
        break;
      case Kind::root:
        if (!inner.prime) result.other = true;
        break;
      case Kind::exponential:
        result.other = true;
        break;
    }
  }
  return result;
}

// Exponentials of different monomials that are not constant are algebraically independent over the
// functions their arguments are made of (Ax, On Schanuel's conjectures, 1971); of different
// algebraic monomials over the algebraic numbers (Lindemann, Weierstrass). With pi beside the
// latter nothing is known.
bool is_independent(const Ring& ring, unsigned id, bool beside_pi) {
  const Atom& atom = ring.atoms().at(id);
  const Contents inside = contents(ring, id);
  switch (atom.kind) {
    case Kind::letter:
    case Kind::placeholder:
    case Kind::pi:
      return true;
    case Kind::jet:
      return !inside.other;
    case Kind::exponential:
      if (is_root_of_unity(ring, atom)) return is_in_small_field(atom);
      if (inside.other || inside.inverses) return false;
      return inside.variables || (!inside.pi && !beside_pi);
    case Kind::root:
      return atom.prime;
    case Kind::inverse:
      return false;
  }
  return false;
}

}  // namespace

ex normal_form(Ring& ring, const ex& polynomial) {
  if (GiNaC::is_a<numeric>(polynomial)) return polynomial;
  const ex cleared = without_inverses(ring, polynomial);
  return with_reduced_roots_of_unity(ring, with_common_exponentials(ring, cleared));
}

bool is_zero(Ring& ring, const ex& polynomial) { return normal_form(ring, polynomial).is_zero(); }

bool is_surely_not_zero(Ring& ring, const ex& input) {
  // If a + b*s is zero for s^2 = r, so is a^2 - b^2*r, whatever else is known of s.
  ex polynomial = input;
  int roots = 0;
  while (const std::optional<unsigned> id = last_of_kind(ring, polynomial, Kind::root)) {
    if (++roots > most_roots) return false;
    const std::map<Powers, ex> parts = coefficients_in(ring, polynomial, *id);
    GiNaC::exvector norm;
    for (const auto& [powers, part] : parts) {
      const ex square = ring.power(part, 2);
      norm.push_back(
          powers.empty() ? square : -ring.product(square, ring.atoms().at(*id).arguments.front()));
    }
    polynomial = normal_form(ring, ring.sum(norm));
  }
  if (polynomial.is_zero()) return false;
  const std::set<unsigned> ids = ring.atoms().occurring(polynomial);
  const bool has_pi = std::any_of(
      ids.begin(), ids.end(), [&](unsigned id) { return ring.atoms().at(id).kind == Kind::pi; });
  return std::all_of(ids.begin(), ids.end(),
                     [&](unsigned id) { return is_independent(ring, id, has_pi); });
}

}  // namespace patchproof::symbolic
