#include <patchproof/language/blossom.hpp>

namespace patchproof {

Term KnotArithmetic::sum(const Term& a, const Term& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  return construct_.sum(Scope{}, {a, b}, "++", span_);
}

Term KnotArithmetic::difference(const Term& a, const Term& b) {
  if (same_knot(a, b)) return number(0);
  if (is_zero(b)) return a;
  return construct_.sum(Scope{}, {a, b}, "+-", span_);
}

Term KnotArithmetic::product(const Term& a, const Term& b) {
  if (is_zero(a) || is_zero(b)) return number(0);
  if (a.is_number() && a.number() == 1) return b;
  if (b.is_number() && b.number() == 1) return a;
  return construct_.product(Scope{}, {a, b}, "**", span_);
}

Term KnotArithmetic::ratio(const Term& a, const Term& b) {
  return construct_.product(Scope{}, {a, b}, "*/", span_);
}

Term KnotArithmetic::combination(const std::vector<Term>& factors, const std::vector<Term>& terms) {
  std::vector<Term> parts;
  for (std::size_t k = 0; k < terms.size(); ++k)
    if (!is_zero(factors[k])) parts.push_back(product(factors[k], terms[k]));
  if (parts.empty()) return construct_.zero(terms.front().type(), span_);
  const std::string signs(parts.size(), '+');
  return construct_.sum(Scope{}, std::move(parts), signs, span_);
}

std::vector<Term> blossom(const Knots& knots, int degree, int span,
                          const std::vector<Term>& arguments, Workshop& workshop,
                          Construction& construct, const Span& where) {
  KnotArithmetic arithmetic{construct, where};
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const auto size = at(degree) + 1;
  std::vector<std::vector<Term>> d(size, std::vector<Term>(size, arithmetic.number(0)));
  for (std::size_t i = 0; i < size; ++i) d[i][i] = arithmetic.number(1);
  for (int level = 1; level <= degree; ++level) {
    const Term& x = arguments[at(level - 1)];
    for (int i = degree; i >= level; --i) {
      const Term& low = knots[at(span - degree + i)];
      const Term& high = knots[at(span + 1 + i - level)];
      const Term length = arithmetic.difference(high, low);
      const Term left = arithmetic.ratio(arithmetic.difference(high, x), length);
      const Term right = arithmetic.ratio(arithmetic.difference(x, low), length);
      for (std::size_t p = 0; p < size; ++p) {
        workshop.count_term(where);
        d[at(i)][p] = arithmetic.sum(arithmetic.product(left, d[at(i) - 1][p]),
                                     arithmetic.product(right, d[at(i)][p]));
      }
    }
  }
  return d[at(degree)];
}

}  // namespace patchproof
