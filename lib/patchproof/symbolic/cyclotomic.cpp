#include <patchproof/symbolic/cyclotomic.hpp>

#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include <patchproof/symbolic/polynomial.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::numeric;
using Coefficients = std::vector<long>;

// Möbius function.
int moebius(long n) {
  int sign = 1;
  for (long p = 2; p <= n; ++p) {
    if (n % p != 0) continue;
    n /= p;
    if (n % p == 0) return 0;
    sign = -sign;
  }
  return sign;
}

// Phi_n = product over d | n of (x^d - 1)^moebius(n/d); multiplications first, so that the
// divisions leave no remainder.
Coefficients cyclotomic_polynomial(long n) {
  Coefficients result{1};
  for (const int wanted : {1, -1}) {
    for (long d = 1; d <= n; ++d) {
      if (n % d != 0 || moebius(n / d) != wanted) continue;
      const auto step = static_cast<std::size_t>(d);
      if (wanted == 1) {
        Coefficients longer(result.size() + step, 0);
        for (std::size_t i = 0; i < result.size(); ++i) {
          longer[i + step] += result[i];
          longer[i] -= result[i];
        }
        result = longer;
      } else {
        for (std::size_t i = result.size() - 1; i >= step; --i) result[i - step] += result[i];
        result.erase(result.begin(), result.begin() + d);
      }
    }
  }
  return result;
}

// Row k holds x^k modulo the cyclotomic polynomial.
std::vector<Coefficients> power_table(long order) {
  const Coefficients modulus = cyclotomic_polynomial(order);
  const std::size_t degree = modulus.size() - 1;
  std::vector<Coefficients> rows;
  Coefficients row(degree, 0);
  row[0] = 1;
  for (long k = 0; k < order; ++k) {
    rows.push_back(row);
    const long carry = row.back();
    for (std::size_t i = degree - 1; i > 0; --i) row[i] = row[i - 1] - carry * modulus[i];
    row[0] = -carry * modulus[0];
  }
  return rows;
}

// An element of the group ring: exponent -> coefficient.
using Element = std::map<long, numeric>;

Element product(const Element& a, const Element& b, long order) {
  Element result;
  for (const auto& [i, x] : a) {
    for (const auto& [j, y] : b) result[(i + j) % order] += x * y;
  }
  return result;
}

bool is_square_modulo(long a, long p) {
  for (long x = 1; x < p; ++x) {
    if (x * x % p == a % p) return true;
  }
  return false;
}

// sqrt(2) = z + 1/z for z = exp(i*pi/4); sqrt(p) is the Gauss sum over exp(2*i*pi/p), divided by i
// when p = 3 modulo 4.
Element square_root_of_prime(long p, long order) {
  Element result;
  if (p == 2) {
    result[order / 8] = 1;
    result[order - order / 8] = 1;
    return result;
  }
  const long turn = p % 4 == 1 ? 0 : order - order / 4;
  for (long k = 1; k < p; ++k) {
    result[(k * (order / p) + turn) % order] += is_square_modulo(k, p) ? 1 : -1;
  }
  return result;
}

// The prime under a root atom when the root lies in the field, else 0.
long prime_in_field(const Atom& atom, long order) {
  if (atom.kind != Atom::Kind::root || !atom.prime) return 0;
  const numeric radicand = GiNaC::ex_to<numeric>(atom.arguments.front());
  if (radicand > numeric{order}) return 0;
  const long prime = radicand.to_long();
  return order % (prime == 2 ? 8 : prime) == 0 ? prime : 0;
}

}  // namespace

// A multiple of 4, so that i is in the field; then sqrt(p) is in it exactly when p (8 for 2)
// divides the order.
long field_order(long divisor) { return 2 * std::lcm(divisor, 2L); }

ex in_cyclotomic_basis(const ex& input, const RootOfUnity& root, Atoms& atoms) {
  const long order = field_order(root.divisor);
  const long step = order / (2 * root.divisor);
  Atom generator = atoms.at(root.atom);
  generator.divisor = numeric{order / 2};
  const unsigned generator_id = atoms.id_of(atoms.symbol_for(generator));

  std::map<Powers, Element> elements;
  for (const Summand& part : summands(input, atoms)) {
    Element element;
    element[0] = part.coefficient.real();
    element[order / 4] += part.coefficient.imag();
    Powers rest;
    for (const auto& [id, exponent] : part.powers) {
      const long prime = prime_in_field(atoms.at(id), order);
      if (id == root.atom) {
        const long turn = exponent % (2 * root.divisor) * step;
        element = product(element, {{(turn + order) % order, 1}}, order);
      } else if (prime != 0) {
        element = product(element, square_root_of_prime(prime, order), order);
      } else {
        rest.emplace_back(id, exponent);
      }
    }
    for (const auto& [k, x] : element) elements[rest][k] += x;
  }

  const std::vector<Coefficients> powers = power_table(order);
  std::vector<Summand> result;
  for (const auto& [rest, element] : elements) {
    std::vector<numeric> basis(powers.front().size(), numeric{0});
    for (const auto& [k, x] : element) {
      const Coefficients& row = powers[static_cast<std::size_t>(k)];
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] != 0) basis[i] += x * numeric{row[i]};
      }
    }
    for (std::size_t i = 0; i < basis.size(); ++i) {
      if (basis[i].is_zero()) continue;
      Powers all = rest;
      if (i > 0) all.emplace_back(generator_id, static_cast<long>(i));
      result.push_back({basis[i], all});
    }
  }
  return polynomial(result, atoms);
}

}  // namespace patchproof::symbolic
