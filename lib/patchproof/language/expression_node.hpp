#pragma once

// Internal to the parser: building the nodes of expressions.

#include <memory>

#include <patchproof/language/token_stream.hpp>

namespace patchproof::grammar {

/// A node still being built.
using Node = std::shared_ptr<syntax::Expression>;

Node node(syntax::Expression::Kind kind, Span span);

/// @throws SyntaxError "nested more deeply than 200 levels"
void set_height(TokenStream& stream, syntax::Expression& expression, int height);

/// One level more than the highest of its parts.
/// @throws SyntaxError "nested more deeply than 200 levels"
void set_height_over(TokenStream& stream, syntax::Expression& expression);

/// After an operand: a number or name on the same line would need an operator before it.
void refuse_implicit_product(TokenStream& stream);

/// The rules; parser_expression.cpp and parser_postfix.cpp give them in full.
Node sum(TokenStream& stream);
Node postfix(TokenStream& stream);

}  // namespace patchproof::grammar
