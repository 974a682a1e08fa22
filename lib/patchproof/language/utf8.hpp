#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace patchproof {

/// How many bytes the character at `at` has; 0 when there is no valid UTF-8 character.
///
/// Overlong forms, surrogates and anything above U+10FFFF are not valid (RFC 3629).
std::size_t utf8_length(std::string_view text, std::size_t at);

/// The mark some editors put at the start of a UTF-8 text; it is not part of the text.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The text with control characters and invalid bytes replaced by U+FFFD, tabs by a blank.
std::string printable(std::string_view text);

}  // namespace patchproof
