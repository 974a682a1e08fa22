#include <patchproof/algebra/polynomial.hpp>

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace patchproof {

Monomial::Monomial(Variable variable, unsigned exponent) {
  if (exponent > 0) powers_.push_back({variable, exponent});
}

unsigned Monomial::exponent(Variable variable) const {
  for (const Power& power : powers_)
    if (power.variable == variable) return power.exponent;
  return 0;
}

unsigned Monomial::total_degree() const {
  unsigned degree = 0;
  for (const Power& power : powers_) degree += power.exponent;
  return degree;
}

Monomial Monomial::without(Variable variable) const {
  Monomial rest;
  for (const Power& power : powers_)
    if (power.variable != variable) rest.powers_.push_back(power);
  return rest;
}

Monomial operator*(const Monomial& a, const Monomial& b) {
  Monomial result;
  auto x = a.powers_.begin();
  auto y = b.powers_.begin();
  while (x != a.powers_.end() || y != b.powers_.end()) {
    if (y == b.powers_.end() || (x != a.powers_.end() && x->variable < y->variable)) {
      result.powers_.push_back(*x++);
    } else if (x == a.powers_.end() || y->variable < x->variable) {
      result.powers_.push_back(*y++);
    } else {
      result.powers_.push_back({x->variable, x->exponent + y->exponent});
      ++x, ++y;
    }
  }
  return result;
}

std::optional<Monomial> quotient(const Monomial& a, const Monomial& b) {
  std::optional<Monomial> result{std::in_place};
  auto y = b.powers_.begin();
  for (const Monomial::Power& power : a.powers_) {
    unsigned exponent = power.exponent;
    if (y != b.powers_.end() && y->variable == power.variable) {
      if (y->exponent > exponent) return std::nullopt;
      exponent -= y->exponent;
      ++y;
    }
    if (exponent > 0) result->powers_.push_back({power.variable, exponent});
  }
  if (y != b.powers_.end()) return std::nullopt;
  return result;
}

std::strong_ordering operator<=>(const Monomial& a, const Monomial& b) {
  const std::size_t common = std::min(a.powers_.size(), b.powers_.size());
  for (std::size_t k = 0; k < common; ++k) {
    const auto& x = a.powers_[k];
    const auto& y = b.powers_[k];
    // The variable with the smaller number is the greater one.
    if (x.variable != y.variable) return y.variable <=> x.variable;
    if (x.exponent != y.exponent) return x.exponent <=> y.exponent;
  }
  return a.powers_.size() <=> b.powers_.size();
}

std::size_t hash_value(const Monomial& monomial) {
  std::size_t hash = 0x9e3779b97f4a7c15U;
  for (const auto& power : monomial.powers()) {
    hash ^= (static_cast<std::size_t>(power.variable) << 32) + power.exponent;
    hash *= 0xff51afd7ed558ccdU;
    hash ^= hash >> 29;
  }
  return hash;
}

Polynomial::Polynomial(const Rational& constant) {
  if (constant != 0) terms_.push_back({Monomial{}, constant});
}

Polynomial Polynomial::variable(Variable variable) {
  Polynomial result;
  result.terms_.push_back({Monomial{variable}, Rational{1}});
  return result;
}

Polynomial Polynomial::from_terms(std::vector<Term> terms) {
  std::sort(terms.begin(), terms.end(),
            [](const Term& a, const Term& b) { return a.monomial > b.monomial; });
  Polynomial result;
  for (Term& term : terms) {
    if (!result.terms_.empty() && result.terms_.back().monomial == term.monomial) {
      result.terms_.back().coefficient += term.coefficient;
    } else {
      if (!result.terms_.empty() && result.terms_.back().coefficient == 0) result.terms_.pop_back();
      result.terms_.push_back(std::move(term));
    }
  }
  if (!result.terms_.empty() && result.terms_.back().coefficient == 0) result.terms_.pop_back();
  return result;
}

Rational Polynomial::constant() const {
  return !terms_.empty() && terms_.back().monomial.is_one() ? terms_.back().coefficient : Rational{0};
}

std::set<Variable> Polynomial::variables() const {
  std::set<Variable> result;
  for (const Term& term : terms_)
    for (const auto& power : term.monomial.powers()) result.insert(power.variable);
  return result;
}

unsigned Polynomial::degree(Variable variable) const {
  unsigned degree = 0;
  for (const Term& term : terms_) degree = std::max(degree, term.monomial.exponent(variable));
  return degree;
}

bool operator<(const Polynomial& a, const Polynomial& b) {
  return std::lexicographical_compare(
      a.terms_.begin(), a.terms_.end(), b.terms_.begin(), b.terms_.end(),
      [](const Polynomial::Term& x, const Polynomial::Term& y) {
        if (x.monomial != y.monomial) return x.monomial > y.monomial;
        return x.coefficient < y.coefficient;
      });
}

namespace {

Polynomial merged(const Polynomial& a, const Polynomial& b, bool subtract, Budget& budget) {
  budget.spend(a.terms().size() + b.terms().size());
  budget.require_terms(a.terms().size() + b.terms().size());
  std::vector<Polynomial::Term> terms;
  terms.reserve(a.terms().size() + b.terms().size());
  auto x = a.terms().begin();
  auto y = b.terms().begin();
  while (x != a.terms().end() || y != b.terms().end()) {
    if (y == b.terms().end() || (x != a.terms().end() && x->monomial > y->monomial)) {
      terms.push_back(*x++);
    } else if (x == a.terms().end() || y->monomial > x->monomial) {
      terms.push_back({y->monomial, subtract ? Rational{-y->coefficient} : y->coefficient});
      ++y;
    } else {
      const Rational coefficient = subtract ? Rational{x->coefficient - y->coefficient}
                                            : Rational{x->coefficient + y->coefficient};
      if (coefficient != 0) terms.push_back({x->monomial, coefficient});
      ++x, ++y;
    }
  }
  return Polynomial::from_terms(std::move(terms));
}

Polynomial times_term(const Polynomial& polynomial, const Polynomial::Term& factor) {
  std::vector<Polynomial::Term> terms;
  terms.reserve(polynomial.terms().size());
  for (const auto& term : polynomial.terms())
    terms.push_back({term.monomial * factor.monomial, term.coefficient * factor.coefficient});
  return Polynomial::from_terms(std::move(terms));
}

}  // namespace

std::uint64_t coefficient_cost(const Rational& a, const Rational& b) {
  const std::uint64_t words = 1 + bit_length(a) / 64 + bit_length(b) / 64;
  return words * words;
}

Polynomial sum(const Polynomial& a, const Polynomial& b, Budget& budget) {
  return merged(a, b, false, budget);
}

Polynomial difference(const Polynomial& a, const Polynomial& b, Budget& budget) {
  return merged(a, b, true, budget);
}

Polynomial product(const Polynomial& a, const Polynomial& b, Budget& budget) {
  if (a.is_zero() || b.is_zero()) return {};
  if (b.terms().size() == 1 || a.terms().size() == 1) {
    const auto& [single, other] = b.terms().size() == 1 ? std::pair{b, a} : std::pair{a, b};
    for (const auto& term : other.terms())
      budget.spend(coefficient_cost(term.coefficient, single.terms().front().coefficient));
    return times_term(other, single.terms().front());
  }
  std::unordered_map<Monomial, Rational> accumulated;
  for (const auto& x : a.terms()) {
    for (const auto& y : b.terms()) {
      budget.spend(coefficient_cost(x.coefficient, y.coefficient));
      accumulated[x.monomial * y.monomial] += x.coefficient * y.coefficient;
    }
    budget.require_terms(accumulated.size());
  }
  std::vector<Polynomial::Term> terms;
  terms.reserve(accumulated.size());
  for (auto& [monomial, coefficient] : accumulated)
    if (coefficient != 0) terms.push_back({monomial, std::move(coefficient)});
  return Polynomial::from_terms(std::move(terms));
}

Polynomial power(const Polynomial& base, unsigned exponent, Budget& budget) {
  Polynomial result{Rational{1}};
  Polynomial square = base;
  for (unsigned rest = exponent; rest > 0; rest /= 2) {
    if (rest % 2 == 1) result = product(result, square, budget);
    if (rest > 1) square = product(square, square, budget);
  }
  return result;
}

Polynomial scaled(const Polynomial& polynomial, const Rational& factor) {
  if (factor == 0) return {};
  return times_term(polynomial, {Monomial{}, factor});
}

Polynomial derivative(const Polynomial& polynomial, Variable variable) {
  std::vector<Polynomial::Term> terms;
  for (const auto& term : polynomial.terms()) {
    const unsigned exponent = term.monomial.exponent(variable);
    if (exponent == 0) continue;
    terms.push_back({term.monomial.without(variable) * Monomial{variable, exponent - 1},
                     term.coefficient * exponent});
  }
  return Polynomial::from_terms(std::move(terms));
}

}  // namespace patchproof
