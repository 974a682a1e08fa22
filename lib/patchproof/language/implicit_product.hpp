#pragma once

#include <string>

#include <patchproof/language/token_stream.hpp>

namespace patchproof {

/// The help for a missing operator before the present token, which follows an operand.
///
/// For `4u(1-u)`: "multiplication is written '*': 4*u*(1-u)". The product is not spelled out when
/// it is long, or runs over a line. A word that resembles a keyword is taken for that.
std::string missing_operator_help(const TokenStream& stream);

}  // namespace patchproof
