#pragma once

#include <patchproof/term/term.hpp>

/// Where the written form of a term needs parentheses, the same in plain text and in any other
/// notation with the usual precedence of operators.
namespace patchproof {

/// How tightly a text holds together, and what an operand must at least have to go without
/// parentheses: a + b < a*b < a^b < f(x). A text that starts with a minus binds like a sum.
enum class Binding { sum, product, power, primary };

Binding binding(const Term& term);

/// Whether the text of the term starts with a minus, so that "a + -b" can become "a - b".
/// Not to be asked of sums, whose operands are asked one by one.
bool starts_with_minus(const Term& term);

/// The term that is written for this one: a function is written as its body.
const Term& written(const Term& term);

/// A product of scalars or of matrices.
bool is_product(const Term& term);

/// Whether the term is written as a name alone, which can carry marks of derivatives: r_u, C1''.
bool has_plain_name(const Term& term);

}  // namespace patchproof
