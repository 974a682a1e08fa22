#pragma once

#include <string_view>

#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// What the dump of a syntax tree calls its nodes: "name", "prove", "scalar function", ...
std::string_view text_of(syntax::Expression::Kind kind);
std::string_view text_of(syntax::Statement::Kind kind);
std::string_view text_of(syntax::FormalType::Kind kind);

}  // namespace patchproof
