#include <algorithm>

#include <patchproof/language/construction.hpp>
#include <patchproof/term/plain_text.hpp>
#include <patchproof/term/replacement.hpp>

namespace patchproof {

namespace {

constexpr std::size_t longest_number_bits = 100'000;

bool has_parameters(const Term& term) {
  for (const auto& [ordinal, symbol] : free_symbols(term))
    if (symbol->role == Symbol::Role::parameter || symbol->role == Symbol::Role::bound) return true;
  return false;
}

}  // namespace

Term Construction::matrix_product(const std::vector<Term>& factors, const Span& span) {
  Type type = factors.front().type();
  for (std::size_t k = 1; k < factors.size(); ++k) {
    const Type& next = factors[k].type();
    if (type.columns != next.rows)
      throw Fault{factors[k].span(),
                  "a " + to_text(type) + " cannot be multiplied by a " + to_text(next),
                  "the columns of the first have to be as many as the rows of the second"};
    if (type.inner->is_point() && next.inner->is_point())
      throw Fault{factors[k].span(), "two matrices of points cannot be multiplied"};
    const Type entry = type.inner->is_point() ? *type.inner : *next.inner;
    type = Type::matrix(type.rows, next.columns, entry);
  }
  return decayed(make(Operation::matrix_product, type, factors, {}, span));
}

// All factors of one product without divisions, as values.
Term Construction::scalar_product(const Scope& scope, const std::vector<Term>& terms,
                                  const std::string&, const Span& span) {
  std::vector<Term> scalars;
  std::vector<Term> matrices;
  std::vector<Term> points;
  Rational number = 1;
  bool only_numbers = true;
  for (const Term& term : terms) {
    const Term factor = value(scope, term);
    only_numbers = only_numbers && factor.is_number();
    if (factor.is_number()) number *= factor.number();
    if (bit_length(number) > longest_number_bits)
      throw Fault{span, "this number has more than " + std::to_string(longest_number_bits) +
                            " binary digits"};
    if (factor.type().is_scalar())
      scalars.push_back(factor);
    else
      (factor.type().is_matrix() ? matrices : points).push_back(factor);
  }
  if (only_numbers) return number_term(number, span);
  if (!matrices.empty()) {
    const Term whole =
        matrices.size() == 1 ? matrices.front() : matrix_product(matrices, span);
    if (whole.type().is_matrix()) {
      if (!points.empty())
        throw Fault{points.front().span(), "a point and a matrix cannot be multiplied"};
      if (scalars.empty()) return whole;
      scalars.push_back(whole);
      return make(Operation::product, whole.type(), std::move(scalars), {}, span);
    }
    (whole.type().is_scalar() ? scalars : points).push_back(whole);
  }
  if (points.size() > 1)
    throw Fault{points[1].span(), "two points cannot be multiplied",
                "the scalar product is dot(a, b), the vector product cross(a, b)"};
  const Type type = points.empty() ? Type::scalar() : points.front().type();
  scalars.insert(scalars.end(), points.begin(), points.end());
  if (scalars.size() == 1) return scalars.front();
  return make(Operation::product, type, std::move(scalars), {}, span);
}

Term Construction::product(const Scope& scope, std::vector<Term> terms, const std::string& signs,
                           const Span& span) {
  if (terms.size() == 1) return terms.front();
  const auto is_function = [](const Term& t) { return t.type().is_function(); };
  const auto functions = std::count_if(terms.begin(), terms.end(), is_function);
  // Looking for parameters walks through whole terms: only where a function stands among them.
  const bool pointwise =
      functions > 0 && std::none_of(terms.begin(), terms.end(), [&](const Term& t) {
        return !is_function(t) && has_parameters(t);
      });
  if (pointwise) {
    const Type type = std::find_if(terms.begin(), terms.end(), is_function)->type();
    return function(type.parameters, span, [&](const std::vector<Term>& formals) {
      std::vector<Term> values;
      for (const Term& term : terms) {
        const bool fits = !is_function(term) || term.type().parameters.size() == formals.size();
        if (!fits)
          throw Fault{term.span(),
                      "functions of different numbers of parameters cannot be multiplied"};
        values.push_back(is_function(term) ? apply(term, formals, span) : term);
      }
      return product(scope, std::move(values), signs, span);
    });
  }
  std::vector<Term> factors;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (signs[k] != '/') {
      factors.push_back(terms[k]);
      continue;
    }
    const Term above = scalar_product(scope, factors, signs, span);
    const Term below = scalar(scope, terms[k], "a divisor");
    if (is_zero(below)) throw Fault{below.span(), "division by zero"};
    if (above.is_number() && below.is_number())
      factors = {number_term(above.number() / below.number(), span)};
    else
      factors = {make(Operation::quotient, above.type(), {above, below}, {}, span)};
  }
  return scalar_product(scope, factors, signs, span);
}

}  // namespace patchproof
