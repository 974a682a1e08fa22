#pragma once

#include <optional>
#include <string>

#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// The value of an expression of numerals, signs and small whole exponents; empty for any other.
std::optional<Rational> value_of(const syntax::Expression& expression);

/// What is written there.
std::string as_text(const Span& span);

}  // namespace patchproof
