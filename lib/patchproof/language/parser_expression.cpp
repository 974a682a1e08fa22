// Expressions and what is made of them:
//
//   expression = [ "-" ] product { ( "+" | "-" ) [ "-" ] product }
//   product    = power { ( "*" | "/" ) power }
//   power      = postfix [ "^" [ "-" ] power ]
//   interval   = expression ".." expression
//   binder     = NAME "in" interval
//   range      = "[" expression "," expression "]"

#include <algorithm>

#include <patchproof/language/expression_node.hpp>
#include <patchproof/language/grammar.hpp>

namespace patchproof::grammar {
namespace {

using syntax::Expression;
using syntax::ExpressionPointer;
using Kind = Expression::Kind;

/// -operand, where the sign has been taken at `sign`.
Node negation(TokenStream& stream, const Token& sign, const Node& operand) {
  const Node result = node(Kind::negation, stream.span_from(sign.begin));
  result->mark = stream.span(sign);
  result->operands.push_back(operand);
  set_height_over(stream, *result);
  return result;
}

Node power(TokenStream& stream) {
  const std::size_t begin = stream.token().begin;
  const Node base = postfix(stream);
  if (!stream.is("^")) return base;
  const Node result = node(Kind::power, {});
  result->mark = stream.span(stream.token());
  const Nested nested(stream, Nested::Kind::operation);
  stream.advance();
  const Token sign = stream.token();
  const bool is_negative = stream.accept("-");
  const Node exponent = power(stream);
  result->operands = {base, is_negative ? negation(stream, sign, exponent) : exponent};
  result->span = stream.span_from(begin);
  set_height_over(stream, *result);
  return result;
}

void append(Expression& list, const Node& operand, char sign) {
  list.operands.push_back(operand);
  list.signs.push_back(sign);
  list.height = std::max(list.height, operand->height);
}

Node product(TokenStream& stream) {
  const std::size_t begin = stream.token().begin;
  const Node first = power(stream);
  if (!stream.is("*") && !stream.is("/")) return first;
  const Node result = node(Kind::product, {});
  result->mark = stream.span(stream.token());
  append(*result, first, '*');
  while (stream.is("*") || stream.is("/")) {
    const char sign = stream.text().front();
    stream.advance();
    append(*result, power(stream), sign);
  }
  result->span = stream.span_from(begin);
  return result;
}

}  // namespace

Node sum(TokenStream& stream) {
  const Token start = stream.token();
  const bool is_negative = stream.accept("-");
  const Node first = product(stream);
  Node result = first;
  if (is_negative || stream.is("+") || stream.is("-")) {
    result = node(Kind::sum, {});
    result->mark = stream.span(is_negative ? start : stream.token());
    append(*result, first, is_negative ? '-' : '+');
    while (stream.is("+") || stream.is("-")) {
      const char sign = stream.text().front();
      stream.advance();
      const Token second_sign = stream.token();
      const bool is_negated = stream.accept("-");
      const Node operand = product(stream);
      append(*result, is_negated ? negation(stream, second_sign, operand) : operand, sign);
    }
    result->span = stream.span_from(start.begin);
  }
  refuse_implicit_product(stream);
  return result;
}

ExpressionPointer expression(TokenStream& stream) { return sum(stream); }

std::vector<ExpressionPointer> expressions(TokenStream& stream) {
  std::vector<ExpressionPointer> result{expression(stream)};
  while (stream.accept(",")) result.push_back(expression(stream));
  return result;
}

syntax::Interval interval(TokenStream& stream) {
  if (stream.is("[")) stream.fail_expected("a range of whole numbers like 0..3");
  syntax::Interval result;
  result.first = expression(stream);
  stream.expect("..");
  result.last = expression(stream);
  return result;
}

syntax::Range range(TokenStream& stream) {
  const std::size_t begin = stream.token().begin;
  if (!stream.is("[")) stream.fail_expected("a range like [0, 1]");
  const Nested nested(stream, Nested::Kind::bracket);
  stream.advance();
  syntax::Range result;
  result.lower = expression(stream);
  stream.expect(",");
  result.upper = expression(stream);
  stream.expect("]");
  result.span = stream.span_from(begin);
  return result;
}

std::vector<syntax::Binder> binders(TokenStream& stream) {
  std::vector<syntax::Binder> result;
  do {
    syntax::Binder binder;
    binder.name = stream.name();
    if (stream.is(":")) {
      stream.fail(stream.span(stream.token()),
                  "'for ... : patch' is not available in this version");
    }
    stream.expect("in");
    binder.interval = interval(stream);
    result.push_back(std::move(binder));
  } while (stream.accept(","));
  return result;
}

std::vector<syntax::Name> formal_parameters(TokenStream& stream) {
  stream.expect("(");
  std::vector<syntax::Name> result = stream.names();
  stream.expect(")");
  for (const syntax::Name& name : result) stream.variables.insert(name.text);
  return result;
}

}  // namespace patchproof::grammar
