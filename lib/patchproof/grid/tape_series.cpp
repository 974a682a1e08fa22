#include <patchproof/grid/tape_builder.hpp>

namespace patchproof {

// c0 + c1*t + c2*t^2 + …
TapeBuilder::Value TapeBuilder::of_polynomial(const std::vector<Rational>& coefficients,
                                              const Series& argument, Scope& scope) {
  std::vector<Series> parts;
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    parts.push_back(product(power(argument, static_cast<unsigned>(k), scope),
                            constant(tape_.number(coefficients[k]), scope), scope));
  std::vector<std::pair<const Series*, bool>> summands;
  for (const Series& part : parts) summands.emplace_back(&part, false);
  return {sum(summands)};
}

TapeBuilder::Value TapeBuilder::of_bernstein(const Term& term, Scope& scope) {
  const int degree = term.indices().at(0);
  const int index = term.indices().at(1);
  // It has to have a value where the result does not depend on it, too.
  const Series& t = value(term.child(0), scope).front();
  if (index < 0 || index > degree) return {constant(Tape::zero, scope)};
  if (degree > highest_basis) throw Declined{"too high a degree"};
  // A sum of Bézier points has each of them many times.
  Series& known = scope.bernstein[{t, degree, index}];
  if (known.empty()) known = bernstein(t, degree, index, scope);
  return {known};
}

TapeBuilder::Series TapeBuilder::bernstein(const Series& argument, int degree, int index,
                                           Scope& scope) {
  const Series one = constant(tape_.number(1), scope);
  const Series rest = sum({{&one, false}, {&argument, true}});
  Rational choices{1};
  for (int k = 1; k <= index; ++k) choices = choices * Rational{degree - index + k} / Rational{k};
  const Series both = product(power(argument, static_cast<unsigned>(index), scope),
                              power(rest, static_cast<unsigned>(degree - index), scope), scope);
  return product(both, constant(tape_.number(choices), scope), scope);
}

TapeBuilder::Series TapeBuilder::constant(Step step, const Scope& scope) const {
  Series result(scope.length, Tape::zero);
  result.front() = step;
  return result;
}

TapeBuilder::Series TapeBuilder::sum(const std::vector<std::pair<const Series*, bool>>& parts) {
  spend(parts.size() * parts.front().first->size());
  Series result(parts.front().first->size(), Tape::zero);
  for (std::size_t k = 0; k < result.size(); ++k) {
    std::vector<Tape::Summand> summands;
    for (const auto& [series, negative] : parts) summands.push_back({(*series)[k], negative});
    result[k] = tape_.sum(std::move(summands));
  }
  return result;
}

TapeBuilder::Series TapeBuilder::product(const Series& a, const Series& b, const Scope& scope) {
  spend(a.size() * b.size());
  if (scope.length == 1) return {tape_.product(a.front(), b.front())};
  std::vector<std::vector<Tape::Summand>> parts(scope.length);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == Tape::zero) continue;
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (b[j] == Tape::zero) continue;
      std::size_t rest_i = i;
      std::size_t rest_j = j;
      bool fits = true;
      for (const unsigned order : scope.orders) {
        fits = fits && rest_i % (order + 1) + rest_j % (order + 1) <= order;
        rest_i /= order + 1;
        rest_j /= order + 1;
      }
      // The powers add up without carrying, and so do their places.
      if (fits) parts[i + j].push_back({tape_.product(a[i], b[j]), false});
    }
  }
  Series result(scope.length, Tape::zero);
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = tape_.sum(std::move(parts[k]));
  return result;
}

TapeBuilder::Series TapeBuilder::power(const Series& base, unsigned exponent, Scope& scope) {
  std::vector<Series>& powers = scope.powers[base];
  if (powers.empty()) powers.push_back(constant(tape_.number(1), scope));
  while (powers.size() <= exponent) powers.push_back(product(powers.back(), base, scope));
  return powers[exponent];
}

}  // namespace patchproof
