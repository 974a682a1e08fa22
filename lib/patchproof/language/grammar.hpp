#pragma once

// Internal to the parser: one function per rule of the grammar. Each takes its piece off the
// stream and throws SyntaxError, the mistake being noted, when the piece is not there.

#include <patchproof/language/token_stream.hpp>

namespace patchproof::grammar {

/// A sum of products of powers; `-` may come first.
syntax::ExpressionPointer expression(TokenStream& stream);

/// Expressions with commas between them.
std::vector<syntax::ExpressionPointer> expressions(TokenStream& stream);

/// `0..3`
syntax::Interval interval(TokenStream& stream);

/// `i in 0..3 {, j in 0..3}`
std::vector<syntax::Binder> binders(TokenStream& stream);

/// `[a, b]`
syntax::Range range(TokenStream& stream);

/// `(u, v)`: formal parameters, remembered as variables.
std::vector<syntax::Name> formal_parameters(TokenStream& stream);

/// What is left of a declaration, a claim or any other statement once its keyword is taken.
void declaration(TokenStream& stream, syntax::Statement& statement);
void claim(TokenStream& stream, syntax::Statement& statement);
void assumption(TokenStream& stream, syntax::Statement& statement);
void show(TokenStream& stream, syntax::Statement& statement);

/// A statement whose keyword comes next, or that is to be read as if `keyword` came next.
/// Notes the mistakes in it and goes to its end; empty when it could not be made sense of.
std::optional<syntax::Statement> statement(TokenStream& stream, std::string_view keyword);

/// From `define` to its `end`.
syntax::Definition definition(TokenStream& stream);

}  // namespace patchproof::grammar
