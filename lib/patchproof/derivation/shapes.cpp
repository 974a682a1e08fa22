#include <patchproof/derivation/shapes.hpp>

#include <algorithm>

namespace patchproof {

Term zero_of(const Type& type) {
  if (type.is_scalar()) return number_term(0);
  const std::size_t count = type.is_matrix()
                                ? static_cast<std::size_t>(type.rows * type.columns)
                                : std::max<std::size_t>(1, static_cast<std::size_t>(type.dimension));
  const Term part = type.is_matrix() ? zero_of(*type.inner) : number_term(0);
  return make_term(type.is_matrix() ? Operation::matrix : Operation::tuple, type,
                   std::vector<Term>(count, part));
}

bool is_number(const Term& term, const Rational& number) {
  return term.is_number() && term.number() == number;
}

bool is_zero_term(const Term& term) {
  if (term.is_number()) return term.number() == 0;
  if (term.operation() == Operation::negation) return is_zero_term(term.child(0));
  if (term.operation() != Operation::tuple && term.operation() != Operation::matrix) return false;
  return std::all_of(term.children().begin(), term.children().end(), is_zero_term);
}

bool is_array(const Term& term) {
  return term.operation() == Operation::matrix &&
         std::all_of(term.children().begin(), term.children().end(), [](const Term& entry) {
           return entry.operation() == Operation::symbol;
         });
}

Term without_name(const Term& term) {
  std::vector<Term> children = term.children();
  const Term& first = children.front();
  children.front() =
      make_term(first.operation(), first.type(), first.children(), first->payload, first.span());
  return make_term(term.operation(), term.type(), std::move(children), term->payload, term.span());
}

Term derivative_of(const Term& function, const Indices& orders) {
  if (std::all_of(orders.begin(), orders.end(), [](int n) { return n == 0; })) return function;
  if (function.operation() != Operation::derivative)
    return make_term(Operation::derivative, function.type(), {function}, orders);
  Indices together = function.indices();
  for (std::size_t k = 0; k < orders.size(); ++k) together[k] += orders[k];
  return make_term(Operation::derivative, function.type(), {function.child(0)}, together);
}

Term sum_of(std::vector<Term> parts, const Type& type) {
  if (parts.empty()) return zero_of(type);
  if (parts.size() == 1) return parts.front();
  return make_term(Operation::sum, type, std::move(parts));
}

}  // namespace patchproof
