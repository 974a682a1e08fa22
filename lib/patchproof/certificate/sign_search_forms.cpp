// The forms in which a polynomial is seen not to be negative.
#include <patchproof/certificate/sign_search.hpp>

#include <algorithm>

#include <patchproof/algebra/odd_part.hpp>
#include <patchproof/algebra/squares.hpp>
#include <patchproof/kernel/polynomial_term.hpp>

namespace patchproof {

namespace {

// The summand times another one.
Summand times(const Summand& a, const Summand& b) {
  Summand result{a.coefficient * b.coefficient, a.squares, a.facts};
  result.squares.insert(result.squares.end(), b.squares.begin(), b.squares.end());
  for (const auto& power : b.facts) {
    const auto same = std::find_if(result.facts.begin(), result.facts.end(),
                                   [&](const auto& f) { return f.first == power.first; });
    if (same == result.facts.end())
      result.facts.push_back(power);
    else
      same->second += power.second;
  }
  return result;
}

Rational power_of(const Rational& base, unsigned exponent) {
  Rational result = 1;
  for (unsigned k = 0; k < exponent; ++k) result *= base;
  return result;
}

// Bernstein coefficients of a polynomial in one of its variables over [low, high], with polynomials
// in the others as coefficients: b_i = sum_{k<=i} C(i,k)/C(n,k) a_k. Source: Farin, ch. 5.
std::vector<Polynomial> bernstein_coefficients(const Polynomial& p, Variable v, const Rational& low,
                                               const Rational& high, Budget& budget) {
  const Polynomial local = substituted(p, {{v, Polynomial::from_terms({{Monomial{v}, high - low}, {Monomial{}, low}})}}, budget);
  const std::vector<Polynomial> power = coefficients(local, v);
  const std::size_t n = power.size() - 1;
  std::vector<Polynomial> result;
  for (std::size_t i = 0; i <= n; ++i) {
    Polynomial total;
    Rational ratio = 1;
    for (std::size_t k = 0; k <= i; ++k) {
      total = sum(total, scaled(power[k], ratio), budget);
      if (k < i) ratio *= Rational{i - k, n - k};
    }
    result.push_back(std::move(total));
  }
  return result;
}

}  // namespace

// A number times facts, times a square.
std::optional<SignSearch::Summands> SignSearch::as_product(const Polynomial& p) {
  Summand summand{1, {}, {}};
  Polynomial rest = p;
  for (std::size_t k = 0; k < facts_.size(); ++k) {
    if (facts_[k].polynomial.is_constant()) continue;
    unsigned exponent = 0;
    while (std::optional<Polynomial> next =
               quotient(rest, facts_[k].polynomial, workspace_.budget)) {
      rest = std::move(*next);
      ++exponent;
    }
    if (exponent > 0) summand.facts.emplace_back(k, exponent);
  }
  if (!rest.is_constant()) {
    const std::optional<Polynomial> root = square_root(rest, workspace_.budget);
    if (!root) return std::nullopt;
    const std::optional<Polynomial> factor =
        quotient(rest, product(*root, *root, workspace_.budget), workspace_.budget);
    if (!factor || !factor->is_constant()) return std::nullopt;
    summand.squares.push_back(scalar_term(*root, workspace_.atoms));
    rest = *factor;
  }
  if (rest.constant() <= 0) return std::nullopt;
  summand.coefficient = rest.constant();
  return Summands{std::move(summand)};
}

// Every term by itself: even powers are squares, other variables have to be facts.
std::optional<SignSearch::Summands> SignSearch::term_by_term(const Polynomial& p) {
  if (p.terms().size() > 200) return std::nullopt;
  Summands result;
  for (const auto& term : p.terms()) {
    if (term.coefficient < 0) return std::nullopt;
    std::optional<Summands> one = as_product(Polynomial::from_terms({term}));
    if (!one) return std::nullopt;
    result.push_back(std::move(one->front()));
  }
  return result;
}

std::optional<SignSearch::Summands> SignSearch::in_bernstein_basis(const Polynomial& p,
                                                                   unsigned depth) {
  for (const Variable v : p.variables()) {
    const std::optional<Bounds> b = bounds(v);
    if (!b || b->low >= b->high) continue;
    const std::vector<Polynomial> parts =
        bernstein_coefficients(p, v, b->low, b->high, workspace_.budget);
    const auto n = static_cast<unsigned>(parts.size() - 1);
    Summands result;
    Rational binomial = 1;
    for (unsigned i = 0; i <= n; ++i) {
      const std::optional<Summands> part = never_negative(parts[i], depth + 1);
      if (!part) return std::nullopt;
      Summand basis{binomial / power_of(b->high - b->low, n) / power_of(b->low_scale, i) /
                        power_of(b->high_scale, n - i),
                    {},
                    {}};
      if (i > 0) basis.facts.emplace_back(b->lower, i);
      if (i < n) basis.facts.emplace_back(b->upper, n - i);
      for (const Summand& summand : *part) result.push_back(times(summand, basis));
      binomial = binomial * (n - i) / (i + 1);
    }
    // One variable after the other is a choice of order, not of a subset: no other order helps.
    return result;
  }
  return std::nullopt;
}

// A polynomial in one variable with a factor of even multiplicity, such as one that touches zero.
std::optional<SignSearch::Summands> SignSearch::without_square(const Polynomial& p, unsigned depth) {
  const std::set<Variable> variables = p.variables();
  if (variables.size() != 1) return std::nullopt;
  const Polynomial odd = odd_part(p, *variables.begin(), workspace_.budget);
  const std::optional<Polynomial> even = quotient(p, odd, workspace_.budget);
  if (!even || even->is_constant()) return std::nullopt;
  const std::optional<Polynomial> root = square_root(*even, workspace_.budget);
  if (!root) return std::nullopt;
  const std::optional<Polynomial> factor =
      quotient(*even, product(*root, *root, workspace_.budget), workspace_.budget);
  if (!factor || !factor->is_constant() || factor->constant() <= 0) return std::nullopt;
  std::optional<Summands> found = never_negative(odd, depth + 1);
  if (!found) return std::nullopt;
  const Summand square{factor->constant(), {scalar_term(*root, workspace_.atoms)}, {}};
  for (Summand& summand : *found) summand = times(summand, square);
  return found;
}

// a*x^2 + b*x + c = a*(x + b/(2a))^2 + c - b^2/(4a), a a positive number.
std::optional<SignSearch::Summands> SignSearch::completed_square(const Polynomial& p,
                                                                 unsigned depth) {
  for (const Variable v : p.variables()) {
    if (p.degree(v) != 2) continue;
    const std::vector<Polynomial> parts = coefficients(p, v);
    if (!parts[2].is_constant() || parts[2].constant() < 0) continue;
    const Rational a = parts[2].constant();
    const Polynomial root = sum(Polynomial::variable(v), scaled(parts[1], 1 / (2 * a)),
                                workspace_.budget);
    const Polynomial rest = difference(
        parts[0], scaled(product(parts[1], parts[1], workspace_.budget), 1 / (4 * a)),
        workspace_.budget);
    std::optional<Summands> found = never_negative(rest, depth + 1);
    if (!found) return std::nullopt;
    found->push_back({a, {scalar_term(root, workspace_.atoms)}, {}});
    return found;
  }
  return std::nullopt;
}

}  // namespace patchproof
