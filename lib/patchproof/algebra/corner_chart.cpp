#include <patchproof/algebra/corner_chart.hpp>

#include <algorithm>

namespace patchproof {

namespace {

// The power coefficients in coordinates counted from the corner: a_k = C(n,k) times the k-th
// difference of the Bernstein coefficients, along each axis. Source: Farin, ch. 5.
std::vector<Rational> powers_from(const BernsteinForm& form, unsigned corner, Budget& budget) {
  const std::vector<unsigned>& degrees = form.degrees();
  std::vector<Rational> tensor{form.coefficients().begin(), form.coefficients().end()};
  std::size_t stride = 1;
  for (std::size_t axis = degrees.size(); axis-- > 0;) {
    const std::size_t n = degrees[axis];
    for (std::size_t first = 0; first < tensor.size(); ++first) {
      if (first / stride % (n + 1) != 0) continue;
      std::vector<Rational> line;
      for (std::size_t i = 0; i <= n; ++i) line.push_back(tensor[first + i * stride]);
      if ((corner >> axis & 1U) != 0) std::reverse(line.begin(), line.end());
      Rational binomial = 1;
      for (std::size_t k = 0; k <= n; ++k) {
        tensor[first + k * stride] = binomial * line.front();
        binomial *= Rational{n - k, k + 1};
        for (std::size_t i = 0; i + 1 < line.size(); ++i) line[i] = line[i + 1] - line[i];
        line.pop_back();
      }
      budget.spend((n + 1) * (n + 1));
    }
    stride *= n + 1;
  }
  return tensor;
}

}  // namespace

CornerChart::CornerChart(const BernsteinForm& form, unsigned corner, std::size_t largest,
                         Budget& budget)
    : corner_{corner}, largest_{largest}, dimension_{form.dimension()} {
  const std::vector<Rational> tensor = powers_from(form, corner, budget);
  struct Term {
    std::vector<unsigned> exponents;
    unsigned total = 0;
    Rational coefficient;
  };
  std::vector<Term> terms;
  for (std::size_t place = 0; place < tensor.size(); ++place) {
    if (tensor[place] == 0) continue;
    Term term{std::vector<unsigned>(dimension_), 0, tensor[place]};
    std::size_t rest = place;
    for (std::size_t axis = dimension_; axis-- > 0;) {
      term.exponents[axis] = static_cast<unsigned>(rest % (form.degrees()[axis] + 1));
      term.total += term.exponents[axis];
      rest /= form.degrees()[axis] + 1;
    }
    terms.push_back(std::move(term));
  }
  unsigned order = terms.empty() ? 0 : terms.front().total;
  for (const Term& term : terms) order = std::min(order, term.total);
  std::vector<Polynomial::Term> result;
  for (const Term& term : terms) {
    Monomial monomial;
    for (std::size_t axis = 0; axis < dimension_; ++axis) {
      const unsigned exponent = axis == largest_ ? term.total - order : term.exponents[axis];
      if (exponent > 0) monomial = monomial * Monomial{static_cast<Variable>(axis), exponent};
    }
    result.push_back({monomial, term.coefficient});
  }
  polynomial_ = Polynomial::from_terms(std::move(result));
}

std::vector<Rational> CornerChart::place(const std::map<Variable, Rational>& point,
                                         Budget& budget) const {
  const auto coordinate = [&](std::size_t axis) {
    const auto found = point.find(static_cast<Variable>(axis));
    return found == point.end() ? Rational{1} : found->second;
  };
  Rational s = coordinate(largest_);
  const auto with_s = [&](const Rational& value) {
    std::map<Variable, Polynomial> images;
    for (std::size_t axis = 0; axis < dimension_; ++axis)
      images.emplace(static_cast<Variable>(axis), axis == largest_ ? value : coordinate(axis));
    return substituted(polynomial_, images, budget).constant();
  };
  if (s == 0) {
    const bool negative = with_s(0) < 0;
    for (s = 1; (with_s(s) < 0) != negative || with_s(s) == 0; s /= 2) budget.spend(16);
  }
  std::vector<Rational> result;
  for (std::size_t axis = 0; axis < dimension_; ++axis) {
    const Rational x = axis == largest_ ? s : Rational{s * coordinate(axis)};
    result.push_back((corner_ >> axis & 1U) != 0 ? Rational{1 - x} : x);
  }
  return result;
}

}  // namespace patchproof
