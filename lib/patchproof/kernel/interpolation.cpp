#include <patchproof/kernel/interpolation.hpp>

#include <algorithm>

#include <patchproof/algebra/linear_system.hpp>

namespace patchproof {

namespace {

// All exponent vectors of total degree exactly `degree`, in lexicographic order.
void exponents_of_degree(int degree, std::size_t variables, std::vector<int>& current,
                         std::vector<std::vector<int>>& result) {
  if (current.size() + 1 == variables) {
    current.push_back(degree);
    result.push_back(current);
    current.pop_back();
    return;
  }
  for (int first = degree; first >= 0; --first) {
    current.push_back(first);
    exponents_of_degree(degree - first, variables, current, result);
    current.pop_back();
  }
}

// The derivative of the monomial at the place of the prescription.
Rational derivative_of(const std::vector<int>& exponents, const Prescription& prescription) {
  Rational result = 1;
  for (std::size_t k = 0; k < exponents.size(); ++k) {
    const int order = prescription.orders[k];
    if (exponents[k] < order) return 0;
    for (int j = 0; j < order; ++j) result *= exponents[k] - j;
    result *= power(prescription.at[k], exponents[k] - order);
  }
  return result;
}

}  // namespace

std::optional<Polynomial> interpolant(const std::vector<Prescription>& prescriptions,
                                      const std::vector<Variable>& variables, Budget& budget) {
  const bool all_zero = std::all_of(prescriptions.begin(), prescriptions.end(),
                                    [](const Prescription& p) { return p.value == 0; });
  if (all_zero) return Polynomial{};
  int highest = 0;
  for (const Prescription& p : prescriptions)
    for (const int order : p.orders) highest += order;
  const int limit = static_cast<int>(prescriptions.size()) + highest;
  std::vector<std::vector<int>> monomials;
  for (int degree = 0; degree <= limit; ++degree) {
    std::vector<int> current;
    exponents_of_degree(degree, variables.size(), current, monomials);
    std::vector<LinearEquation> equations;
    for (const Prescription& p : prescriptions) {
      LinearEquation equation{{}, Rational{p.value}};
      for (const auto& exponents : monomials)
        equation.coefficients.push_back(derivative_of(exponents, p));
      equations.push_back(std::move(equation));
    }
    const LinearSolution found = solution(std::move(equations), monomials.size(), budget);
    if (!found.contradictions.empty()) continue;
    std::vector<Polynomial::Term> terms;
    for (std::size_t m = 0; m < monomials.size(); ++m) {
      Monomial monomial;
      for (std::size_t k = 0; k < variables.size(); ++k)
        monomial = monomial * Monomial{variables[k], static_cast<unsigned>(monomials[m][k])};
      terms.push_back({monomial, found.constant_part[m].numerator().constant()});
    }
    return Polynomial::from_terms(std::move(terms));
  }
  return std::nullopt;
}

}  // namespace patchproof
