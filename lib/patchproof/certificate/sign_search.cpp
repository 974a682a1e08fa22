#include <patchproof/certificate/sign_search.hpp>

#include <algorithm>

#include <patchproof/algebra/bernstein_form.hpp>
#include <patchproof/kernel/polynomial_term.hpp>

namespace patchproof {

namespace {

constexpr unsigned most_cuts = 7;
// How many polynomials are looked at for one goal.
constexpr std::size_t most_work = 20'000;

Polynomial linear_polynomial(Variable v, const Rational& factor, const Rational& constant) {
  return Polynomial::from_terms({{Monomial{v}, factor}, {Monomial{}, constant}});
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
  if (std::optional<Summands> found = without_square(p, depth)) return found;
  return completed_square(p, depth);
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
