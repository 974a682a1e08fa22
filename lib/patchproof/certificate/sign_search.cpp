#include <patchproof/certificate/sign_search.hpp>

#include <algorithm>

#include <patchproof/algebra/bernstein_form.hpp>
#include <patchproof/algebra/squares.hpp>
#include <patchproof/kernel/polynomial_term.hpp>

namespace patchproof {

namespace {

constexpr unsigned most_cuts = 7;
// How many polynomials are looked at for one goal.
constexpr std::size_t most_work = 20'000;

Polynomial linear_polynomial(Variable v, const Rational& factor, const Rational& constant) {
  return Polynomial::from_terms({{Monomial{v}, factor}, {Monomial{}, constant}});
}

// The summand times another one.
Summand times(const Summand& a, const Summand& b) {
  Summand result{a.coefficient * b.coefficient, a.squares, a.facts};
  result.squares.insert(result.squares.end(), b.squares.begin(), b.squares.end());
  for (const auto& [fact, exponent] : b.facts) {
    const auto same = std::find_if(result.facts.begin(), result.facts.end(),
                                   [&](const auto& f) { return f.first == fact; });
    if (same == result.facts.end())
      result.facts.emplace_back(fact, exponent);
    else
      same->second += exponent;
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
  const Polynomial local = substituted(p, {{v, linear_polynomial(v, high - low, low)}}, budget);
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

SignSearch::SignSearch(std::vector<SignedPolynomial> facts, Workspace& workspace)
    : facts_{std::move(facts)}, workspace_{workspace} {}

std::optional<SignProof> SignSearch::proof(const SignedPolynomial& goal,
                                           const std::vector<Cofactor>& cofactors) {
  work_ = 0;
  for (unsigned cuts = 0; cuts <= most_cuts; ++cuts)
    if (std::optional<SignProof> found = search(goal, cofactors, cuts)) return found;
  return std::nullopt;
}

std::optional<SignProof> SignSearch::search(const SignedPolynomial& goal,
                                            const std::vector<Cofactor>& cofactors, unsigned cuts) {
  if (work_ > most_work) return std::nullopt;
  if (std::optional<Summands> found = summands(goal)) {
    SignProof proof;
    proof.end = Combination{std::move(*found), cofactors};
    return proof;
  }
  return cuts == 0 ? std::nullopt : cut(goal, cofactors, cuts);
}

// Cuts the longest interval in the middle; both halves have to succeed.
std::optional<SignProof> SignSearch::cut(const SignedPolynomial& goal,
                                         const std::vector<Cofactor>& cofactors, unsigned cuts) {
  std::optional<Bounds> longest;
  for (const Variable v : goal.polynomial.variables())
    if (const std::optional<Bounds> found = bounds(v))
      if (found->high > found->low &&
          (!longest || found->high - found->low > longest->high - longest->low))
        longest = found;
  if (!longest) return std::nullopt;
  const Rational middle = (longest->low + longest->high) / 2;
  const Polynomial at = linear_polynomial(longest->variable, 1, -middle);
  SignProof result;
  SignProof::Cut both{scalar_term(at, workspace_.atoms), {}};
  for (const bool upper : {true, false}) {
    const std::size_t before = facts_.size();
    facts_.push_back({upper ? at : scaled(at, -1), false});
    std::optional<SignProof> found = half(goal, cofactors, cuts - 1, *longest, upper);
    facts_.resize(before);
    if (!found) return std::nullopt;
    both.cases.push_back(std::move(*found));
  }
  result.end = std::move(both);
  return result;
}

// In one half the distance from the far end is positive, which a strict goal may need.
std::optional<SignProof> SignSearch::half(const SignedPolynomial& goal,
                                          const std::vector<Cofactor>& cofactors, unsigned cuts,
                                          const Bounds& bounds, bool upper_half) {
  if (!goal.strict) return search(goal, cofactors, cuts);
  const Rational length = bounds.high - bounds.low;
  const Polynomial distance = upper_half ? linear_polynomial(bounds.variable, 1, -bounds.low)
                                         : linear_polynomial(bounds.variable, -1, bounds.high);
  SignProof::Step step{scalar_term(distance, workspace_.atoms), true, {}};
  step.why.summands = {{length / 2, {}, {}}, {1, {}, {{facts_.size() - 1, 1}}}};
  const std::size_t before = facts_.size();
  facts_.push_back({distance, true});
  std::optional<SignProof> found = search(goal, cofactors, cuts);
  facts_.resize(before);
  if (found) found->steps.insert(found->steps.begin(), std::move(step));
  return found;
}

bool SignSearch::is_strict(const Summands& summands) const {
  return std::any_of(summands.begin(), summands.end(), [&](const Summand& summand) {
    return summand.squares.empty() &&
           std::all_of(summand.facts.begin(), summand.facts.end(),
                       [&](const auto& fact) { return facts_[fact.first].strict; });
  });
}

std::optional<SignSearch::Summands> SignSearch::summands(const SignedPolynomial& goal) {
  if (std::optional<Summands> found = linear(goal)) return found;
  if (!goal.strict) return never_negative(goal.polynomial, 0);
  // p - m >= 0 for a number m > 0: the least Bernstein coefficient is the best to be had.
  Box box;
  for (const Variable v : goal.polynomial.variables())
    if (const std::optional<Bounds> found = bounds(v)) box[v] = {found->low, found->high};
  if (box.size() == goal.polynomial.variables().size() && !box.empty()) {
    const BernsteinForm form{goal.polynomial, box, workspace_.budget};
    const Rational least =
        Rational{*std::min_element(form.coefficients().begin(), form.coefficients().end())} *
        form.scale();
    if (least > 0) {
      const Polynomial rest =
          sum(goal.polynomial, Polynomial{Rational{-least}}, workspace_.budget);
      if (std::optional<Summands> found = never_negative(rest, 0)) {
        found->push_back({least, {}, {}});
        return found;
      }
    }
  }
  std::optional<Summands> found = never_negative(goal.polynomial, 0);
  return found && is_strict(*found) ? found : std::nullopt;
}

std::optional<SignSearch::Summands> SignSearch::never_negative(const Polynomial& p, unsigned depth) {
  workspace_.budget.spend(1);
  if (++work_ > most_work || depth > 40) return std::nullopt;
  if (p.is_constant()) {
    if (p.constant() < 0) return std::nullopt;
    return p.is_zero() ? Summands{} : Summands{{p.constant(), {}, {}}};
  }
  if (std::optional<Summands> found = as_product(p)) return found;
  if (std::optional<Summands> found = term_by_term(p)) return found;
  if (std::optional<Summands> found = linear({p, false})) return found;
  if (std::optional<Summands> found = in_bernstein_basis(p, depth)) return found;
  return completed_square(p, depth);
}

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

std::optional<SignSearch::Summands> SignSearch::linear(const SignedPolynomial& goal) {
  const auto factors = farkas_factors(facts_, goal, workspace_.budget);
  if (!factors) return std::nullopt;
  Summands result;
  Polynomial rest = goal.polynomial;
  for (std::size_t k = 0; k < factors->size(); ++k) {
    if ((*factors)[k] == 0) continue;
    result.push_back({(*factors)[k], {}, {{k, 1}}});
    rest = difference(rest, scaled(facts_[k].polynomial, (*factors)[k]), workspace_.budget);
  }
  if (rest.constant() != 0) result.push_back({rest.constant(), {}, {}});
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

// The tightest bounds among the facts about the variable alone.
std::optional<SignSearch::Bounds> SignSearch::bounds(Variable variable) const {
  Bounds result{variable, 0, 0, 0, 0, 0, 0};
  bool below = false;
  bool above = false;
  for (std::size_t k = 0; k < facts_.size(); ++k) {
    const Polynomial& fact = facts_[k].polynomial;
    if (fact.degree(variable) != 1 || fact.variables().size() != 1) continue;
    const Rational slope = coefficients(fact, variable)[1].constant();
    const Rational end = -fact.constant() / slope;
    if (slope > 0 && (!below || end > result.low || (end == result.low && facts_[k].strict))) {
      below = true;
      result.low = end;
      result.lower = k;
      result.low_scale = slope;
    }
    if (slope < 0 && (!above || end < result.high || (end == result.high && facts_[k].strict))) {
      above = true;
      result.high = end;
      result.upper = k;
      result.high_scale = -slope;
    }
  }
  if (!below || !above) return std::nullopt;
  return result;
}

}  // namespace patchproof
