#include "written_out.hpp"

namespace patchproof::differential {

Node rational(const Rational& value) {
  const bool is_negative = value < 0;
  const Rational size = is_negative ? Rational{-value} : value;
  const Node positive = number(to_text(size));
  return is_negative ? negative(positive) : positive;
}

Node written_out(const PlainPolynomial& p) {
  std::vector<Node> terms;
  for (const auto& [monomial, coefficient] : p) {
    std::vector<Node> factors{rational(coefficient)};
    for (const auto& [name, exponent] : monomial)
      factors.push_back(power(scalar_name(name), exponent));
    terms.push_back(product(factors));
  }
  return sum(terms);
}

}  // namespace patchproof::differential
