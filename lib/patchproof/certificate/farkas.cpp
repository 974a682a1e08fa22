#include <patchproof/certificate/farkas.hpp>

#include <algorithm>

namespace patchproof {

namespace {

// Elimination doubles the rows at worst; beyond this it is given up.
constexpr std::size_t most_rows = 2000;

// polynomial >= 0, or > 0: a combination of the given ones, the goal's negative being the last.
struct Row {
  Polynomial polynomial;
  bool strict = false;
  std::vector<Rational> factors;
};

bool is_linear(const Polynomial& polynomial) {
  return std::all_of(polynomial.terms().begin(), polynomial.terms().end(),
                     [](const auto& term) { return term.monomial.total_degree() <= 1; });
}

Rational coefficient(const Polynomial& polynomial, Variable variable) {
  return polynomial.degree(variable) == 0 ? Rational{0}
                                          : coefficients(polynomial, variable).at(1).constant();
}

Row combined(const Row& a, const Rational& times_a, const Row& b, const Rational& times_b,
             Budget& budget) {
  Row result{sum(scaled(a.polynomial, times_a), scaled(b.polynomial, times_b), budget),
             a.strict || b.strict,
             a.factors};
  for (std::size_t k = 0; k < result.factors.size(); ++k)
    result.factors[k] = a.factors[k] * times_a + b.factors[k] * times_b;
  return result;
}

}  // namespace

std::optional<std::vector<Rational>> farkas_factors(const std::vector<SignedPolynomial>& facts,
                                                    const SignedPolynomial& goal, Budget& budget) {
  if (!is_linear(goal.polynomial)) return std::nullopt;
  std::vector<Row> rows;
  const std::size_t count = facts.size() + 1;
  for (std::size_t k = 0; k < facts.size(); ++k) {
    if (!is_linear(facts[k].polynomial)) continue;
    rows.push_back({facts[k].polynomial, facts[k].strict, std::vector<Rational>(count)});
    rows.back().factors[k] = 1;
  }
  rows.push_back({scaled(goal.polynomial, -1), !goal.strict, std::vector<Rational>(count)});
  rows.back().factors.back() = 1;
  std::set<Variable> variables;
  for (const Row& row : rows) variables.merge(row.polynomial.variables());
  for (const Variable v : variables) {
    std::vector<Row> next;
    std::vector<Row> above;
    std::vector<Row> below;
    for (Row& row : rows) {
      const Rational c = coefficient(row.polynomial, v);
      (c > 0 ? above : c < 0 ? below : next).push_back(std::move(row));
    }
    for (const Row& a : above)
      for (const Row& b : below) {
        budget.spend(1);
        next.push_back(combined(a, -coefficient(b.polynomial, v), b, coefficient(a.polynomial, v),
                                budget));
        if (next.size() > most_rows) return std::nullopt;
      }
    rows = std::move(next);
  }
  // Facts that contradict each other show anything.
  const auto contradiction = std::find_if(rows.begin(), rows.end(), [](const Row& row) {
    return row.factors.back() == 0 && row.polynomial.constant() < 0;
  });
  for (Row& row : rows) {
    const Rational of_goal = row.factors.back();
    if (of_goal == 0) continue;
    if (contradiction != rows.end() && row.polynomial.constant() >= 0)
      row = combined(row, 1, *contradiction,
                     (row.polynomial.constant() + 1) / -contradiction->polynomial.constant(),
                     budget);
    const Rational left = row.polynomial.constant();
    if (left > 0 || (left == 0 && !row.strict)) continue;
    // sum factors*facts - of_goal*goal = left, so goal = sum (factors/of_goal)*facts - left/of_goal.
    std::vector<Rational> result{row.factors.begin(), row.factors.end() - 1};
    for (Rational& factor : result) factor /= of_goal;
    return result;
  }
  return std::nullopt;
}

}  // namespace patchproof
