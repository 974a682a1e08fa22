// The operands of expressions:
//
//   postfix = primary { "(" arguments ")" | "[" indices "]" | "." ( "x" | "y" | "z" ) }
//   primary = NUMBER | NAME | "?" | "(" expression { "," expression } ")" | matrix
//   matrix  = "[" row { ";" row } "]"

#include <patchproof/language/expression_node.hpp>
#include <patchproof/language/grammar.hpp>
#include <patchproof/language/implicit_product.hpp>
#include <patchproof/language/keywords.hpp>

namespace patchproof::grammar {
namespace {

using syntax::Argument;
using syntax::Expression;
using syntax::ExpressionPointer;
using Kind = Expression::Kind;

[[noreturn]] void fail_missing_operator(TokenStream& stream) {
  const Token& next = stream.token();
  stream.fail(stream.span(next), "expected an operator before " + shown(stream, next),
              missing_operator_help(stream));
}

/// Whether the next token goes on with the line's expression; outside of brackets a '(' or '['
/// that is first on its line does not.
bool continues_here(const TokenStream& stream) {
  return !stream.token().first_on_line || Nested::in_brackets(stream);
}

Node number(TokenStream& stream) {
  const Node result = node(Kind::number, stream.span(stream.token()));
  result->text = stream.text();
  // The lexer lets only numbers through that can be read.
  result->number = number_from_text(result->text).value_or(Rational{0});
  stream.advance();
  if (continues_here(stream) && (stream.is("(") || stream.is("["))) fail_missing_operator(stream);
  return result;
}

Node parenthesised(TokenStream& stream) {
  const Token open = stream.token();
  const Nested nested(stream, Nested::Kind::bracket);
  stream.advance();
  const Node first = sum(stream);
  if (stream.accept(")")) {
    first->parenthesised = true;
    first->span = stream.span_from(open.begin);
    set_height(stream, *first, first->height + 1);
    return first;
  }
  const Node result = node(Kind::tuple, {});
  result->mark = stream.span(open);
  result->operands.push_back(first);
  while (stream.accept(",")) result->operands.push_back(sum(stream));
  if (!stream.accept(")")) stream.fail_expected("',' or ')'");
  result->span = stream.span_from(open.begin);
  set_height_over(stream, *result);
  return result;
}

std::string entries(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

Node matrix(TokenStream& stream) {
  const Token open = stream.token();
  const Nested nested(stream, Nested::Kind::bracket);
  stream.advance();
  const Node result = node(Kind::matrix, {});
  result->mark = stream.span(open);
  do {
    std::vector<ExpressionPointer> row{sum(stream)};
    while (stream.accept(",")) row.push_back(sum(stream));
    result->rows.push_back(std::move(row));
  } while (stream.accept(";"));
  if (!stream.accept("]")) stream.fail_expected("',', ';' or ']'");
  result->span = stream.span_from(open.begin);
  const std::size_t width = result->rows.front().size();
  for (std::size_t i = 1; i < result->rows.size(); ++i) {
    const std::size_t found = result->rows[i].size();
    if (found == width) continue;
    stream.fail(result->mark, "rows of unequal length: row 1 has " + entries(width) + ", row " +
                                  std::to_string(i + 1) + " has " + std::to_string(found));
  }
  set_height_over(stream, *result);
  return result;
}

Node primary(TokenStream& stream) {
  if (stream.at_statement()) stream.fail_expected("an expression");
  if (stream.is(Token::Kind::number)) return number(stream);
  if (stream.is(Token::Kind::name) && !is_inner_keyword(stream.text())) {
    const Node result = node(Kind::name, stream.span(stream.token()));
    result->text = stream.text();
    stream.advance();
    return result;
  }
  if (stream.is("?")) {
    stream.advance();
    return node(Kind::hole, stream.span(stream.tokens()[stream.index() - 1]));
  }
  if (stream.is("(")) return parenthesised(stream);
  if (stream.is("[")) return matrix(stream);
  const Token& before = stream.tokens()[stream.index() - (stream.index() > 0 ? 1 : 0)];
  std::string help;
  if (stream.is("*") && stream.text(before) == "*") help = "a power is written '^'";
  if (stream.is(Token::Kind::name)) {
    help = "'" + std::string(stream.text()) + "' is a word of the language";
  }
  if (stream.is("-")) help = "write a second sign in parentheses: (-x)";
  if (stream.is(".") && stream.is(Token::Kind::number, 1)) {
    help = "write 0." + std::string(stream.text(1)).substr(0, 20);
  }
  stream.fail_expected("an expression", std::move(help));
}

/// One argument of a call: an expression, `i in 0..3` or `u in [0, 1]`.
Argument call_argument(TokenStream& stream, const Expression& callee) {
  Argument result;
  if (!stream.is(Token::Kind::name) || !stream.is("in", 1)) {
    result.value = sum(stream);
    return result;
  }
  syntax::Binder binder;
  binder.name = stream.name();
  stream.expect("in");
  if (stream.is("[") && callee.kind == Kind::name && callee.text == "integral") {
    result.range = syntax::RangeBinder{std::move(binder.name), range(stream)};
    return result;
  }
  binder.interval = interval(stream);
  result.binder = std::move(binder);
  return result;
}

/// One index: an expression, or `0..3`.
Argument index_argument(TokenStream& stream) {
  Argument result;
  result.value = sum(stream);
  if (stream.accept("..")) {
    result.interval = syntax::Interval{std::move(result.value), sum(stream)};
    result.value = nullptr;
  }
  return result;
}

}  // namespace

void refuse_implicit_product(TokenStream& stream) {
  const Token& next = stream.token();
  if (next.first_on_line) return;
  if (next.kind == Token::Kind::name) {
    if (is_inner_keyword(stream.text())) return;
    if (begins_statement(stream.text())) stream.fail_same_line();
  } else if (next.kind != Token::Kind::number && !stream.is("?")) {
    return;
  }
  fail_missing_operator(stream);
}

Node postfix(TokenStream& stream) {
  const std::size_t begin = stream.token().begin;
  Node result = primary(stream);
  while (true) {
    const Token operation = stream.token();
    const bool is_call = stream.is("(") && continues_here(stream);
    const bool is_index = stream.is("[") && continues_here(stream);
    if (!is_call && !is_index && !stream.is(".")) return result;
    const Node outer = node(is_call ? Kind::call : is_index ? Kind::index : Kind::component, {});
    outer->mark = stream.span(operation);
    outer->operands.push_back(result);
    if (is_call || is_index) {
      const Nested nested(stream, Nested::Kind::bracket);
      stream.advance();
      const std::string_view close = is_call ? ")" : "]";
      if (!is_call || !stream.is(close)) {
        do {
          outer->arguments.push_back(is_call ? call_argument(stream, *result)
                                             : index_argument(stream));
        } while (stream.accept(","));
      }
      if (!stream.accept(close)) stream.fail_expected("',' or '" + std::string(close) + "'");
    } else {
      stream.advance();
      if (!stream.is("x") && !stream.is("y") && !stream.is("z")) {
        stream.fail_expected("'x', 'y' or 'z' after '.'");
      }
      outer->text = stream.any_word("a component").text;
    }
    outer->span = stream.span_from(begin);
    set_height_over(stream, *outer);
    result = outer;
  }
}

}  // namespace patchproof::grammar
