// Signs of polynomials that are not linear: what SignFacts::sign does.

#include <algorithm>

#include <patchproof/algebra/squares.hpp>
#include <patchproof/kernel/sign_facts.hpp>

namespace patchproof {

namespace {

constexpr unsigned most_degree = 60;
constexpr std::size_t most_coefficients = 20'000;
constexpr unsigned most_symbolic_cuts = 6;

// The Bernstein coefficients, polynomials in the other variables, in the order of BernsteinForm:
// b_i = sum_{k<=i} C(i,k)/C(n,k) a_k along each axis. Source: Farin, ch. 5.
std::vector<Polynomial> symbolic_coefficients(const Polynomial& polynomial, const Box& box,
                                              Budget& budget) {
  std::map<Variable, Polynomial> to_unit;
  for (const Variable v : polynomial.variables()) {
    const auto side = box.find(v);
    to_unit.emplace(
        v, side == box.end()
               ? Polynomial::variable(v)
               : Polynomial::from_terms({{Monomial{}, side->second.low},
                                         {Monomial{v}, side->second.high - side->second.low}}));
  }
  std::vector<Polynomial> parts{substituted(polynomial, to_unit, budget)};
  for (const auto& [v, side] : box) {
    const std::size_t n = polynomial.degree(v);
    std::vector<Polynomial> next;
    for (const Polynomial& part : parts) {
      std::vector<Polynomial> powers = coefficients(part, v);
      powers.resize(n + 1);
      for (std::size_t i = 0; i <= n; ++i) {
        Polynomial total;
        Rational ratio = 1;
        for (std::size_t k = 0; k <= i; ++k) {
          total = sum(total, scaled(powers[k], ratio), budget);
          if (k < i) ratio *= Rational{i - k, n - k};
        }
        next.push_back(std::move(total));
      }
    }
    parts = std::move(next);
    budget.require_terms(parts.size());
  }
  return parts;
}

// The polynomial as a sum of coefficients, in symbols, times monomials in the variables of the box.
std::map<Monomial, Polynomial> by_box_monomials(const Polynomial& polynomial, const Box& box) {
  std::map<Monomial, std::vector<Polynomial::Term>> parts;
  for (const auto& term : polynomial.terms()) {
    Monomial inside;
    Monomial outside;
    for (const auto& p : term.monomial.powers()) {
      Monomial& part = box.contains(p.variable) ? inside : outside;
      part = part * Monomial{p.variable, p.exponent};
    }
    parts[inside].push_back({outside, term.coefficient});
  }
  std::map<Monomial, Polynomial> result;
  for (auto& [inside, terms] : parts)
    result.emplace(inside, Polynomial::from_terms(std::move(terms)));
  return result;
}

bool fits(const Polynomial& polynomial, const Box& box) {
  for (const auto& [variable, interval] : box)
    if (polynomial.degree(variable) > most_degree) return false;
  return box.size() <= most_box_variables && bernstein_size(polynomial, box) <= most_coefficients;
}

}  // namespace

Box SignFacts::box_of(const Polynomial& polynomial) const {
  Box result;
  for (const Variable v : polynomial.variables()) {
    std::optional<Rational> low;
    std::optional<Rational> high;
    const auto raise = [&](const Rational& value) { low = low ? std::max(*low, value) : value; };
    const auto lower = [&](const Rational& value) { high = high ? std::min(*high, value) : value; };
    if (const auto declared = intervals_.find(v); declared != intervals_.end()) {
      raise(declared->second.low);
      lower(declared->second.high);
    }
    // a*v + b >= 0 is a bound too; whether the end itself belongs to the interval does not matter.
    for (const Inequality& inequality : inequalities_) {
      const Polynomial& p = inequality.polynomial;
      if (p.degree(v) != 1 || p.variables().size() != 1) continue;
      const Rational slope = p.terms().front().coefficient;
      if (slope > 0)
        raise(-p.constant() / slope);
      else
        lower(-p.constant() / slope);
    }
    if (low && high && *low <= *high) result.emplace(v, Interval{*low, *high});
  }
  return result;
}

// Positive multiples of products, each factor a square or known not to be negative; strict: one of
// the products is known to be positive.
bool SignFacts::is_sum_of_signed(const Polynomial& polynomial, bool strict, Budget& budget) const {
  bool some_positive = false;
  for (const auto& term : polynomial.terms())
    if (term.coefficient < 0) return false;
  const auto known = [&](Variable v, LinearConstraint::Kind kind) {
    return impossible(scaled(Polynomial::variable(v), -1), kind, budget);
  };
  std::map<Variable, bool> not_negative;
  std::map<Variable, bool> positive;
  for (const auto& term : polynomial.terms()) {
    bool all_positive = true;
    for (const auto& p : term.monomial.powers()) {
      const Variable v = p.variable;
      if (p.exponent % 2 == 1) {
        if (!not_negative.contains(v))
          not_negative[v] = known(v, LinearConstraint::Kind::above_zero);
        if (!not_negative[v]) return false;
      }
      if (strict && !positive.contains(v))
        positive[v] = known(v, LinearConstraint::Kind::at_least_zero);
      all_positive = all_positive && strict && positive[v];
    }
    some_positive = some_positive || all_positive;
  }
  return !strict || some_positive;
}

// Factors that are known to be positive are taken out, and, unless the question is strict, those
// that are known not to be negative and squares. Bounds of single variables are left to the boxes.
Polynomial SignFacts::without_known_factors(const Polynomial& polynomial, bool strict,
                                            Budget& budget) const {
  Polynomial rest = polynomial;
  const auto take_out = [&](const Polynomial& factor) {
    while (!factor.is_constant() && !rest.is_constant()) {
      const std::optional<Polynomial> shorter = quotient(rest, factor, budget);
      if (!shorter) return;
      rest = *shorter;
    }
  };
  for (const Inequality& inequality : inequalities_) {
    const Polynomial& factor = inequality.polynomial;
    const bool is_bound = factor.variables().size() == 1 && !box_of(factor).empty();
    if (inequality.strict || (!strict && !is_bound)) take_out(factor);
  }
  for (const Polynomial& factor : not_zero_) take_out(product(factor, factor, budget));
  if (strict) return rest;
  for (const Variable v : rest.variables()) {
    unsigned least = rest.degree(v);
    for (const auto& term : rest.terms()) least = std::min(least, term.monomial.exponent(v));
    if (least >= 2)
      rest = quotient(rest, Polynomial::from_terms({{Monomial{v, least / 2 * 2}, 1}}), budget)
                 .value_or(rest);
  }
  return rest;
}

SignAnswer SignFacts::sign(const Polynomial& polynomial, bool strict, Budget& budget) const {
  using Kind = SignAnswer::Kind;
  const auto constant_sign = [&](const Polynomial& p) {
    return (strict ? p.constant() > 0 : p.constant() >= 0) ? Kind::shown : Kind::unknown;
  };
  if (polynomial.is_constant()) return {constant_sign(polynomial), {}, {}};
  const bool linear = impossible(
      scaled(polynomial, -1),
      strict ? LinearConstraint::Kind::at_least_zero : LinearConstraint::Kind::above_zero, budget);
  if (linear || is_sum_of_signed(polynomial, strict, budget) ||
      is_definite(polynomial, strict, budget))
    return {Kind::shown, {}, {}};
  if (const auto root = square_root(polynomial, budget))
    if (!strict || never_zero(*root, budget)) return {Kind::shown, {}, {}};
  const Polynomial rest = without_known_factors(polynomial, strict, budget);
  if (rest.is_constant()) return {constant_sign(rest), {}, {}};
  if (rest == polynomial) return sign_by_boxes(rest, strict, budget);
  return sign(rest, strict, budget);
}

SignAnswer SignFacts::sign_by_boxes(const Polynomial& polynomial, bool strict,
                                    Budget& budget) const {
  using Kind = SignAnswer::Kind;
  const Box box = box_of(polynomial);
  if (box.empty() || !fits(polynomial, box)) return {};
  if (box.size() < polynomial.variables().size())
    return sign_with_symbols(polynomial, box, strict, budget);
  BoxSign found = sign_over_box(polynomial, box, strict, budget);
  if (found.answer == BoxSign::Answer::fails) {
    // The place may be one that the assumptions leave out: b = 0 where a < b is assumed, too.
    Box declared = box;
    std::erase_if(declared, [&](const auto& side) { return !intervals_.contains(side.first); });
    if (!declared.empty() && declared.size() < box.size()) {
      SignAnswer answer = sign_with_symbols(polynomial, declared, strict, budget);
      if (answer.shown()) return answer;
    }
  }
  SignAnswer result{Kind::shown, found.tree, std::move(found.point)};
  if (found.answer == BoxSign::Answer::open) result.kind = Kind::undecided;
  if (found.answer != BoxSign::Answer::fails) return result;
  result.kind = found.value == 0 ? Kind::zero : Kind::negative;
  if (result.kind == Kind::negative) return result;
  BoxSign weaker = sign_over_box(polynomial, box, false, budget);
  if (weaker.answer == BoxSign::Answer::fails)
    return {Kind::negative, weaker.tree, std::move(weaker.point)};
  if (weaker.answer == BoxSign::Answer::shown) {
    result.kind = Kind::only_zero;
    result.tree = weaker.tree;
  }
  return result;
}

SignAnswer SignFacts::sign_with_symbols(const Polynomial& polynomial, const Box& box, bool strict,
                                        Budget& budget) const {
  const std::map<Monomial, Polynomial> parts = by_box_monomials(polynomial, box);
  const Polynomial common = primitive(parts.begin()->second).polynomial;
  std::vector<Polynomial::Term> numbers;
  for (const auto& [monomial, coefficient] : parts) {
    const Primitive its = primitive(coefficient);
    if (its.polynomial == common) numbers.push_back({monomial, its.scale});
  }
  if (numbers.size() == parts.size()) {
    const Polynomial rest = Polynomial::from_terms(std::move(numbers));
    if (sign(common, strict, budget).shown()) return sign(rest, strict, budget);
    if (sign(scaled(common, -1), strict, budget).shown())
      return sign(scaled(rest, -1), strict, budget);
    return {};
  }
  SignAnswer answer;
  if (symbolic_sign(polynomial, box, 0, strict, answer, budget))
    answer.kind = SignAnswer::Kind::shown;
  return answer;
}

// Bernstein coefficients with symbols in them. A corner is a value: where its sign does not follow
// from the facts, cutting does not help.
bool SignFacts::symbolic_sign(const Polynomial& polynomial, const Box& box, unsigned cuts,
                              bool strict, SignAnswer& answer, Budget& budget) const {
  const std::vector<Polynomial> parts = symbolic_coefficients(polynomial, box, budget);
  for (unsigned bits = 0; bits < 1U << box.size(); ++bits) {
    std::size_t place = 0;
    unsigned axis = 0;
    std::map<Variable, Rational> corner;
    for (const auto& [v, side] : box) {
      const bool upper = (bits >> axis++ & 1U) != 0;
      place = place * (polynomial.degree(v) + 1) + (upper ? polynomial.degree(v) : 0);
      corner.emplace(v, upper ? side.high : side.low);
    }
    if (sign(parts[place], strict, budget).shown()) continue;
    answer.point = std::move(corner);
    return false;
  }
  answer.tree.depth = std::max(answer.tree.depth, cuts);
  const bool all = std::all_of(parts.begin(), parts.end(), [&](const Polynomial& part) {
    return sign(part, strict, budget).shown();
  });
  if (all) ++answer.tree.boxes;
  if (all || cuts >= most_symbolic_cuts) return all;
  const auto axis = std::next(box.begin(), static_cast<std::ptrdiff_t>(cuts % box.size()));
  const Rational middle = (axis->second.low + axis->second.high) / 2;
  for (const bool upper : {false, true}) {
    Box half = box;
    Interval& side = half[axis->first];
    (upper ? side.low : side.high) = middle;
    if (!symbolic_sign(polynomial, half, cuts + 1, strict, answer, budget)) return false;
  }
  return true;
}

SignAnswer SignFacts::apart_from_zero(const Polynomial& polynomial, Budget& budget) const {
  using Kind = SignAnswer::Kind;
  if (polynomial.is_constant()) return {polynomial.is_zero() ? Kind::unknown : Kind::shown, {}, {}};
  Polynomial rest = primitive(polynomial).polynomial;
  for (const Polynomial& factor : not_zero_) {
    if (factor.is_constant()) continue;
    while (!rest.is_constant()) {
      const std::optional<Polynomial> shorter = quotient(rest, factor, budget);
      if (!shorter) break;
      rest = *shorter;
    }
  }
  if (rest.is_constant()) return {Kind::shown, {}, {}};
  SignAnswer above = sign(rest, true, budget);
  if (above.shown()) return above;
  SignAnswer below = sign(scaled(rest, -1), true, budget);
  if (below.shown()) return below;
  if (impossible(rest, LinearConstraint::Kind::zero, budget)) return {Kind::shown, {}, {}};
  for (SignAnswer* answer : {&above, &below})
    if (answer->kind == Kind::only_zero || answer->kind == Kind::zero) return *answer;
  if (above.kind == Kind::negative && below.kind == Kind::negative) below.kind = Kind::changes;
  return above.kind == Kind::undecided ? above : below;
}

}  // namespace patchproof
