#include <patchproof/symbolic/ring.hpp>

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include <patchproof/symbolic/exact_number.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

constexpr std::size_t most_terms_ever = 200'000;
constexpr std::size_t most_bits = std::size_t{1} << 24;
constexpr std::size_t most_bits_in_all = std::size_t{1} << 31;
constexpr long largest_exponent = 1'000'000;
// What GiNaC does for one pair of summands costs about as much as so many steps of a kernel.
constexpr std::uint64_t steps_per_summand = 200;
// Pieces of this many pairs of summands take GiNaC some milliseconds.
constexpr std::size_t pairs_per_piece = 4096;

struct Extent {
  std::size_t terms = 0;
  std::size_t bits = 0;
  /// The smallest and largest exponent of each atom.
  std::map<unsigned, std::pair<long, long>> exponents;
};

Extent extent(const ex& polynomial, const Atoms& atoms) {
  Extent result;
  for (const Summand& part : unordered_summands(polynomial, atoms)) {
    ++result.terms;
    result.bits = std::max(result.bits, bit_length(part.coefficient));
    for (const auto& [id, exponent] : part.powers) {
      auto& [low, high] = result.exponents[id];
      low = std::min(low, exponent);
      high = std::max(high, exponent);
    }
  }
  return result;
}

void require_exponents(const Extent& size, unsigned long factor) {
  for (const auto& [id, range] : size.exponents) {
    const long largest = std::max(std::labs(range.first), std::labs(range.second));
    if (factor > 0 && largest > largest_exponent / static_cast<long>(factor)) {
      throw OverBudget{"an exponent above " + std::to_string(largest_exponent)};
    }
  }
}

// a*b, but never more than `cap`.
std::size_t capped_product(std::size_t a, std::size_t b, std::size_t cap) {
  if (a == 0 || b == 0) return 0;
  return a > cap / b ? cap : std::min(cap, a * b);
}

// How many monomials there are with exponents in the ranges of a plus those of b.
std::size_t box(Extent a, const Extent& b, unsigned long times_a, std::size_t cap) {
  for (auto& [id, range] : a.exponents) {
    range.first *= static_cast<long>(times_a);
    range.second *= static_cast<long>(times_a);
  }
  for (const auto& [id, range] : b.exponents) {
    a.exponents[id].first += range.first;
    a.exponents[id].second += range.second;
  }
  std::size_t result = 1;
  for (const auto& [id, range] : a.exponents) {
    result = capped_product(result, static_cast<std::size_t>(range.second - range.first + 1), cap);
  }
  return result;
}

// C(exponent + terms - 1, terms - 1): the summands of a power of a sum.
std::size_t multinomial_count(std::size_t terms, unsigned long exponent, std::size_t cap) {
  std::size_t result = 1;
  for (std::size_t i = 1; i < terms; ++i) {
    // Below the cap times an exponent and a number of summands: no overflow.
    result = result * (exponent + i) / i;
    if (result >= cap) return cap;
  }
  return result;
}

// Numbers of a word make coefficients only a little longer.
bool is_small_number(const ex& factor) {
  return GiNaC::is_exactly_a<numeric>(factor) &&
         bit_length(GiNaC::ex_to<numeric>(factor)) <= 64;
}

std::pair<ex, ex> halves(const ex& polynomial) {
  const std::size_t middle = polynomial.nops() / 2;
  GiNaC::exvector first;
  GiNaC::exvector second;
  for (std::size_t i = 0; i < polynomial.nops(); ++i) {
    (i < middle ? first : second).push_back(polynomial.op(i));
  }
  return {sum(first), sum(second)};
}

}  // namespace

Ring::Ring(const Limits& limits)
    : budget_{limits},
      most_terms_{limits.terms == 0 ? most_terms_ever : std::min(limits.terms, most_terms_ever)} {}

void Ring::require_terms(std::size_t terms) const {
  if (terms > most_terms_) {
    throw OverBudget{"more than " + std::to_string(most_terms_) + " terms"};
  }
}

void Ring::require_bits(std::size_t terms, std::size_t bits) const {
  if (bits > most_bits || bits > most_bits_in_all / std::max<std::size_t>(terms, 1)) {
    throw OverBudget{"coefficients of more than " + std::to_string(most_bits) + " bits"};
  }
}

ex Ring::sum(const GiNaC::exvector& parts) {
  std::size_t terms = 0;
  for (const ex& part : parts) terms += term_count(part);
  spend(1 + terms);
  // What cancels is not known yet, so the parts may have more terms than the result.
  if (terms > 4 * most_terms_) require_terms(terms);
  const ex result = symbolic::sum(parts);
  require_terms(term_count(result));
  return result;
}

ex Ring::product(const ex& a, const ex& b) {
  if (a.is_zero() || b.is_zero()) return 0;
  if (is_small_number(a) || is_small_number(b)) {
    spend(steps_per_summand * (term_count(a) + term_count(b)));
    return (a * b).expand();
  }
  const Extent left = extent(a, atoms_);
  const Extent right = extent(b, atoms_);
  require_exponents(left, 2);
  require_exponents(right, 2);
  std::size_t terms = left.terms * right.terms;
  if (terms > most_terms_) terms = std::min(terms, box(left, right, 1, most_terms_ + 1));
  require_terms(terms);
  require_bits(terms, left.bits + right.bits);
  // All at once, so that a product that costs too much is not begun.
  spend(steps_per_summand * (1 + left.terms * right.terms));
  return without_squares_of_roots(product_in_pieces(a, b));
}

ex Ring::product_in_pieces(const ex& a, const ex& b) {
  const std::size_t rows = term_count(a);
  const std::size_t columns = term_count(b);
  if (rows < columns) return product_in_pieces(b, a);
  if (rows * columns <= pairs_per_piece || rows == 1) {
    spend(1 + rows * columns);
    return (a * b).expand();
  }
  const auto [first, second] = halves(a);
  return product_in_pieces(first, b) + product_in_pieces(second, b);
}

ex Ring::power(const ex& base, unsigned long exponent) {
  if (exponent == 0) return 1;
  if (exponent == 1 || base.is_zero()) return base;
  const Extent size = extent(base, atoms_);
  if (exponent > static_cast<unsigned long>(largest_exponent)) {
    throw OverBudget{"an exponent above " + std::to_string(largest_exponent)};
  }
  require_exponents(size, exponent);
  const std::size_t cap = most_terms_ + 1;
  const std::size_t multinomial = multinomial_count(size.terms, exponent, cap);
  const std::size_t terms = std::min(multinomial, box(size, {}, exponent, cap));
  require_terms(terms);
  require_bits(terms, (size.bits + std::bit_width(size.terms)) * exponent);
  if (multinomial <= most_terms_ / 8) {
    spend(steps_per_summand * (1 + terms));
    return without_squares_of_roots(GiNaC::pow(base, numeric{exponent}).expand());
  }
  const ex half = power(base, exponent / 2);
  const ex square = product(half, half);
  return exponent % 2 == 0 ? square : product(square, base);
}

ex Ring::without_squares_of_roots(const ex& polynomial) {
  if (!atoms_.has_roots()) return polynomial;
  bool changed = false;
  GiNaC::exvector parts;
  const auto is_root = [this](unsigned id) { return atoms_.at(id).kind == Atom::Kind::root; };
  for (const auto& [powers, coefficient] : coefficients(polynomial, atoms_, is_root)) {
    ex part = coefficient;
    for (const auto& [id, exponent] : powers) {
      if (exponent % 2 != 0) part = product_in_pieces(part, atoms_.symbol(id));
    }
    for (const auto& [id, exponent] : powers) {
      if (exponent < 2) continue;
      changed = true;
      const ex radicand = atoms_.at(id).arguments.front();
      part = product(part, power(radicand, static_cast<unsigned long>(exponent / 2)));
    }
    parts.push_back(part);
  }
  return changed ? sum(parts) : polynomial;
}

}  // namespace patchproof::symbolic
