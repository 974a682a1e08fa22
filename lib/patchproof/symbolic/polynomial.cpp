#include <patchproof/symbolic/polynomial.hpp>

#include <algorithm>
#include <stdexcept>

#include <patchproof/symbolic/exact_number.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_exactly_a;
using GiNaC::numeric;

void multiply_by(const ex& factor, const Atoms& atoms, Summand& summand) {
  if (is_exactly_a<numeric>(factor)) {
    const numeric& number = ex_to<numeric>(factor);
    if (!is_exact(number)) throw std::logic_error{"a coefficient is not an exact number"};
    summand.coefficient *= number;
  } else if (is_exactly_a<GiNaC::symbol>(factor)) {
    summand.powers.emplace_back(atoms.id_of(factor), 1);
  } else if (is_exactly_a<GiNaC::power>(factor) && is_exactly_a<numeric>(factor.op(1)) &&
             ex_to<numeric>(factor.op(1)).is_integer()) {
    summand.powers.emplace_back(atoms.id_of(factor.op(0)), ex_to<numeric>(factor.op(1)).to_long());
  } else {
    throw std::logic_error{"an expression that is not an expanded polynomial in atoms"};
  }
}

Summand summand(const ex& term, const Atoms& atoms) {
  Summand result{1, {}};
  if (is_exactly_a<GiNaC::mul>(term)) {
    for (std::size_t i = 0; i < term.nops(); ++i) multiply_by(term.op(i), atoms, result);
  } else {
    multiply_by(term, atoms, result);
  }
  std::sort(result.powers.begin(), result.powers.end());
  return result;
}

}  // namespace

std::vector<Summand> unordered_summands(const ex& polynomial, const Atoms& atoms) {
  std::vector<Summand> result;
  if (polynomial.is_zero()) return result;
  if (!is_exactly_a<GiNaC::add>(polynomial)) {
    result.push_back(summand(polynomial, atoms));
    return result;
  }
  result.reserve(polynomial.nops());
  for (std::size_t i = 0; i < polynomial.nops(); ++i) {
    result.push_back(summand(polynomial.op(i), atoms));
  }
  return result;
}

std::vector<Summand> summands(const ex& polynomial, const Atoms& atoms) {
  std::vector<Summand> result = unordered_summands(polynomial, atoms);
  std::sort(result.begin(), result.end(),
            [](const Summand& a, const Summand& b) { return a.powers < b.powers; });
  return result;
}

ex monomial(const Powers& powers, const Atoms& atoms) {
  GiNaC::exvector factors;
  for (const auto& [id, exponent] : powers) {
    factors.push_back(GiNaC::pow(atoms.symbol(id), numeric{exponent}));
  }
  return GiNaC::mul{factors};
}

ex polynomial(const std::vector<Summand>& summands, const Atoms& atoms) {
  GiNaC::exvector parts;
  parts.reserve(summands.size());
  for (const Summand& part : summands) {
    parts.push_back(part.coefficient * monomial(part.powers, atoms));
  }
  return sum(parts);
}

std::map<Powers, ex> coefficients(const ex& polynomial, const Atoms& atoms,
                                  const std::function<bool(unsigned)>& chosen) {
  std::map<Powers, GiNaC::exvector> parts;
  for (const Summand& part : unordered_summands(polynomial, atoms)) {
    Powers outside;
    Powers inside;
    for (const auto& power : part.powers) (chosen(power.first) ? outside : inside).push_back(power);
    parts[outside].push_back(part.coefficient * monomial(inside, atoms));
  }
  std::map<Powers, ex> result;
  for (const auto& [powers, list] : parts) result.emplace(powers, sum(list));
  return result;
}

std::size_t term_count(const ex& polynomial) {
  if (is_exactly_a<GiNaC::add>(polynomial)) return polynomial.nops();
  return polynomial.is_zero() ? 0 : 1;
}

long exponent_of(const Powers& powers, unsigned id) {
  for (const auto& [atom, exponent] : powers) {
    if (atom == id) return exponent;
  }
  return 0;
}

bool is_larger(const Powers& a, const Powers& b) {
  std::size_t i = 0;
  for (; i < a.size() && i < b.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (a[i].first == b[i].first) return a[i].second > b[i].second;
    return a[i].first < b[i].first ? a[i].second > 0 : b[i].second < 0;
  }
  if (i < a.size()) return a[i].second > 0;
  return i < b.size() && b[i].second < 0;
}

ex sum(const GiNaC::exvector& parts) { return GiNaC::add{parts}; }

}  // namespace patchproof::symbolic
