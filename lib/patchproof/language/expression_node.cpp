#include <algorithm>

#include <patchproof/language/expression_node.hpp>
#include <patchproof/language/parser.hpp>

namespace patchproof::grammar {

using syntax::Argument;
using syntax::Expression;
using syntax::ExpressionPointer;

Node node(Expression::Kind kind, Span span) {
  Node result = std::make_shared<Expression>();
  result->kind = kind;
  result->span = std::move(span);
  return result;
}

void set_height(TokenStream& stream, Expression& expression, int height) {
  expression.height = height;
  if (height > deepest_nesting) {
    stream.fail(expression.mark.source ? expression.mark : expression.span,
                "nested more deeply than " + std::to_string(deepest_nesting) + " levels");
  }
}

void set_height_over(TokenStream& stream, Expression& expression) {
  int height = 0;
  const auto include = [&](const ExpressionPointer& part) {
    if (part) height = std::max(height, part->height);
  };
  const auto include_both = [&](const syntax::Interval& interval) {
    include(interval.first);
    include(interval.last);
  };
  for (const ExpressionPointer& operand : expression.operands) include(operand);
  for (const Argument& argument : expression.arguments) {
    include(argument.value);
    if (argument.interval) include_both(*argument.interval);
    if (argument.binder) include_both(argument.binder->interval);
    if (argument.range) {
      include(argument.range->range.lower);
      include(argument.range->range.upper);
    }
  }
  for (const auto& row : expression.rows) {
    for (const ExpressionPointer& entry : row) include(entry);
  }
  set_height(stream, expression, height + 1);
}

}  // namespace patchproof::grammar
