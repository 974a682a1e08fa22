#include <recheck/polynomial.hpp>

#include <algorithm>

namespace recheck {

bool MonomialOrder::operator()(const Monomial& a, const Monomial& b) const {
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    if (a[k].atom != b[k].atom) return a[k].atom > b[k].atom;
    if (a[k].exponent != b[k].exponent) return a[k].exponent < b[k].exponent;
  }
  return a.size() < b.size();
}

bool PolynomialOrder::operator()(const Polynomial& a, const Polynomial& b) const {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

Polynomial constant(const Rational& number) {
  Polynomial result;
  if (number != 0) result.emplace(Monomial{}, number);
  return result;
}

Polynomial variable(Atom atom) { return {{Monomial{{atom, 1}}, Rational{1}}}; }

void add(Polynomial& to, const Monomial& monomial, const Rational& coefficient) {
  if (coefficient == 0) return;
  const auto [place, fresh] = to.emplace(monomial, coefficient);
  if (fresh) return;
  place->second += coefficient;
  if (place->second == 0) to.erase(place);
}

Monomial product(const Monomial& a, const Monomial& b, const Meter& meter) {
  Monomial result;
  result.reserve(a.size() + b.size());
  auto left = a.begin();
  auto right = b.begin();
  while (left != a.end() || right != b.end()) {
    if (right == b.end() || (left != a.end() && left->atom < right->atom)) {
      result.push_back(*left++);
    } else if (left == a.end() || right->atom < left->atom) {
      result.push_back(*right++);
    } else {
      const unsigned exponent = left->exponent + right->exponent;
      Meter::require(exponent, meter.limits().exponent, "exponents");
      result.push_back({left->atom, exponent});
      ++left;
      ++right;
    }
  }
  return result;
}

namespace {

// What a product of two numbers costs: common factors are looked for in all of their words.
std::size_t price(const Rational& a, const Rational& b) {
  const std::size_t words = 1 + extra_words(a) + extra_words(b);
  return words * words;
}

}  // namespace

Polynomial sum(const Polynomial& a, const Polynomial& b, Meter& meter) {
  Polynomial result = a;
  for (const auto& [monomial, coefficient] : b) {
    meter.spend(1 + extra_words(coefficient));
    add(result, monomial, coefficient);
  }
  Meter::require(result.size(), meter.limits().terms, "terms");
  return result;
}

Polynomial scaled(const Polynomial& a, const Rational& factor, Meter& meter) {
  if (factor == 0) return {};
  Polynomial result = a;
  for (auto& [monomial, coefficient] : result) {
    meter.spend(price(coefficient, factor));
    coefficient *= factor;
  }
  return result;
}

Polynomial product(const Polynomial& a, const Polynomial& b, Meter& meter) {
  Polynomial result;
  for (const auto& [left, x] : a) {
    for (const auto& [right, y] : b) {
      meter.spend(price(x, y) + left.size() + right.size());
      add(result, product(left, right, meter), x * y);
    }
    Meter::require(result.size(), meter.limits().terms, "terms");
  }
  return result;
}

namespace {

std::optional<Monomial> quotient(const Monomial& a, const Monomial& b) {
  Monomial result;
  auto right = b.begin();
  for (const Power& power : a) {
    if (right == b.end() || right->atom != power.atom) {
      result.push_back(power);
      continue;
    }
    if (right->exponent > power.exponent) return std::nullopt;
    if (right->exponent < power.exponent)
      result.push_back({power.atom, power.exponent - right->exponent});
    ++right;
  }
  if (right != b.end()) return std::nullopt;
  return result;
}

}  // namespace

std::optional<Polynomial> exact_quotient(const Polynomial& a, const Polynomial& b, Meter& meter) {
  const auto& [leading, leading_coefficient] = *b.rbegin();
  Polynomial rest = a;
  Polynomial result;
  while (!rest.empty()) {
    const std::optional<Monomial> monomial = quotient(rest.rbegin()->first, leading);
    if (!monomial) return std::nullopt;
    const Rational coefficient = rest.rbegin()->second / leading_coefficient;
    result.emplace(*monomial, coefficient);
    for (const auto& [other, factor] : b) {
      meter.spend(price(coefficient, factor));
      add(rest, product(*monomial, other, meter), -coefficient * factor);
    }
    Meter::require(rest.size(), meter.limits().terms, "terms");
  }
  return result;
}

std::optional<Rational> number_in(const Polynomial& a) {
  if (a.empty()) return Rational{0};
  if (a.size() == 1 && a.begin()->first.empty()) return a.begin()->second;
  return std::nullopt;
}

Polynomial partial_derivative(const Polynomial& a, Atom atom, Meter& meter) {
  Polynomial result;
  for (const auto& [monomial, coefficient] : a) {
    meter.spend(1 + monomial.size());
    for (std::size_t k = 0; k < monomial.size(); ++k) {
      if (monomial[k].atom != atom) continue;
      Monomial lower = monomial;
      if (--lower[k].exponent == 0) lower.erase(lower.begin() + static_cast<std::ptrdiff_t>(k));
      add(result, lower, coefficient * monomial[k].exponent);
    }
  }
  return result;
}

std::set<Atom> atoms_in(const Polynomial& a) {
  std::set<Atom> result;
  for (const auto& [monomial, coefficient] : a)
    for (const Power& power : monomial) result.insert(power.atom);
  return result;
}

}  // namespace recheck
