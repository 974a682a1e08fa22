#include <patchproof/term/binding.hpp>

namespace patchproof {

bool is_product(const Term& term) {
  return term.operation() == Operation::product || term.operation() == Operation::matrix_product;
}

bool has_plain_name(const Term& term) {
  return term.operation() == Operation::symbol ||
         (term.operation() == Operation::definition && term.children().size() == 1);
}

const Term& written(const Term& term) {
  const Term* body = &term;
  while (body->operation() == Operation::lambda) body = &body->child(0);
  return *body;
}

bool starts_with_minus(const Term& term) {
  // What is written first is the first factor's first factor; a sum there goes into parentheses.
  const Term* start = &written(term);
  while (is_product(*start) || start->operation() == Operation::quotient) {
    start = &written(start->child(0));
  }
  if (start->is_number()) return start->number() < 0;
  return start->operation() == Operation::negation;
}

Binding binding(const Term& function_or_value) {
  const Term& term = written(function_or_value);
  switch (term.operation()) {
    case Operation::number:
      if (term.number() < 0) return Binding::sum;
      return denominator(term.number()) == 1 ? Binding::primary
                                                                    : Binding::product;
    case Operation::sum:
    case Operation::negation:
      return Binding::sum;
    case Operation::product:
    case Operation::matrix_product:
    case Operation::quotient:
      return starts_with_minus(term) ? Binding::sum : Binding::product;
    case Operation::power:
      return Binding::power;
    default:
      return Binding::primary;
  }
}

}  // namespace patchproof
