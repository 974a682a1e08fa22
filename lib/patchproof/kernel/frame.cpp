#include <patchproof/kernel/frame.hpp>

#include <algorithm>
#include <utility>

#include <patchproof/algebra/linear_system.hpp>

namespace patchproof {

namespace {

constexpr int highest_degree = 8;

Rational factorial(int n) {
  Rational result = 1;
  for (int k = 2; k <= n; ++k) result *= k;
  return result;
}

// All monomials of total degree at most `degree`.
std::vector<Monomial> monomials_up_to(int degree, const std::vector<Variable>& variables) {
  std::vector<Monomial> result{Monomial{}};
  for (const Variable v : variables) {
    std::vector<Monomial> longer;
    for (const Monomial& m : result)
      for (int k = 0; static_cast<int>(m.total_degree()) + k <= degree; ++k)
        longer.push_back(k == 0 ? m : m * Monomial{v, static_cast<unsigned>(k)});
    result = std::move(longer);
  }
  return result;
}

Rational derivative_at(Polynomial p, const Prescription& prescription,
                       const std::vector<Variable>& variables, Budget& budget) {
  std::map<Variable, Polynomial> place;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    for (int order = 0; order < prescription.orders[k]; ++order) p = derivative(p, variables[k]);
    place.emplace(variables[k], Polynomial{prescription.at[k]});
  }
  return substituted(p, place, budget).constant();
}

}  // namespace

// The correction is a multiple of what vanishes on the earlier edges, so that they keep their
// values, and of (x - at)^order/order!: base + (what is missing) * vanishing / (vanishing on the
// edge). Dividing by the latter needs it to divide what is missing, which it does when the edges
// agree at their corners.
void add_edge(const EdgePolynomial& edge, Frame& frame, Budget& budget) {
  const Polynomial offset =
      difference(Polynomial::variable(edge.slot), Polynomial{edge.at}, budget);
  // The vanishing without its factor on this edge, and how often that factor occurs.
  Polynomial rest = frame.vanishing;
  int have = 0;
  while (!rest.is_constant()) {
    std::optional<Polynomial> shorter = quotient(rest, offset, budget);
    if (!shorter) break;
    rest = std::move(*shorter);
    ++have;
  }
  Polynomial base = frame.base;
  for (int k = 0; k < edge.order; ++k) base = derivative(base, edge.slot);
  const std::map<Variable, Polynomial> there{{edge.slot, Polynomial{edge.at}}};
  const Polynomial missing = difference(edge.value, substituted(base, there, budget), budget);
  const Polynomial across = substituted(rest, there, budget);
  if (have <= edge.order && !missing.is_zero() && !across.is_zero()) {
    if (const std::optional<Polynomial> ratio = quotient(missing, across, budget)) {
      const Polynomial power_of_offset = scaled(
          power(offset, static_cast<unsigned>(edge.order), budget), 1 / factorial(edge.order));
      const Polynomial correction = product(product(rest, power_of_offset, budget), *ratio, budget);
      frame.base = sum(frame.base, correction, budget);
    }
  }
  // Order k is kept by what vanishes there k + 1 times.
  for (int k = have; k <= edge.order; ++k)
    frame.vanishing = product(frame.vanishing, offset, budget);
}

std::optional<Polynomial> framed_interpolant(const std::vector<Prescription>& prescriptions,
                                             const Frame& frame,
                                             const std::vector<Variable>& variables,
                                             Budget& budget) {
  for (int degree = 0; degree <= highest_degree; ++degree) {
    std::vector<Polynomial> basis;
    for (const Monomial& m : monomials_up_to(degree, variables))
      basis.push_back(product(Polynomial::from_terms({{m, 1}}), frame.vanishing, budget));
    std::vector<LinearEquation> equations;
    for (const Prescription& p : prescriptions) {
      LinearEquation equation{
          {}, Fraction{Rational{p.value - derivative_at(frame.base, p, variables, budget)}}};
      for (const Polynomial& b : basis)
        equation.coefficients.emplace_back(Rational{derivative_at(b, p, variables, budget)});
      equations.push_back(std::move(equation));
    }
    const LinearSolution found = solution(std::move(equations), basis.size(), budget);
    if (!found.contradictions.empty()) continue;
    Polynomial result = frame.base;
    for (std::size_t k = 0; k < basis.size(); ++k)
      result = sum(result, scaled(basis[k], found.constant_part[k].numerator().constant()), budget);
    return result;
  }
  return std::nullopt;
}

}  // namespace patchproof
