#pragma once

#include <string>
#include <string_view>

namespace patchproof {

/// The SHA-256 digest of the bytes, as 64 hexadecimal digits.
/// Source: FIPS 180-4, Secure Hash Standard.
std::string sha256(std::string_view bytes);

}  // namespace patchproof
