#include <patchproof/kernel/integral_signs.hpp>

#include <algorithm>

#include <patchproof/kernel/integral.hpp>

namespace patchproof {

namespace {

bool is_sum_of_squares(const Fraction& integrand) {
  if (!integrand.is_polynomial()) return false;
  const auto& terms = integrand.numerator().terms();
  return std::all_of(terms.begin(), terms.end(), [](const Polynomial::Term& term) {
    const auto& powers = term.monomial.powers();
    return term.coefficient > 0 && std::all_of(powers.begin(), powers.end(),
                                               [](const auto& p) { return p.exponent % 2 == 0; });
  });
}

bool is_forward(const IntegrationRange& range, const SignFacts& facts, Budget& budget) {
  const Fraction length = difference(range.upper, range.lower, budget);
  return length.is_polynomial() && facts.never_negative(length.numerator(), budget);
}

}  // namespace

SignFacts with_signs_of_integrals(const SignFacts& facts, const Polynomial& polynomial,
                                  Workspace& workspace) {
  SignFacts result = facts;
  for (const Variable v : polynomial.variables()) {
    const Atom& atom = workspace.atoms[v];
    if (atom.kind != Atom::Kind::integral || !is_sum_of_squares(atom.arguments.front())) continue;
    const IntegrationRanges ranges = ranges_of(atom, workspace.atoms);
    const bool forward = std::all_of(ranges.begin(), ranges.end(), [&](const auto& range) {
      return is_forward(range, facts, workspace.budget);
    });
    if (forward) result.add_inequality(Polynomial::variable(v), false);
  }
  return result;
}

}  // namespace patchproof
