#include <patchproof/certificate/rocq_tokens.hpp>

#include <array>
#include <cctype>

namespace patchproof {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool continues_name(char c) { return starts_name(c) || is_digit(c) || c == '\''; }

// The longest come first.
constexpr std::array<std::string_view, 9> long_signs{"%nat", "<=", ">=", "<>", "->",
                                                     "=>",   "/\\", "\\/", ":="};

std::size_t length_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  if (starts_name(text[at])) {
    // "Derive.Derive" is one name.
    while (end < text.size() &&
           (continues_name(text[end]) ||
            (text[end] == '.' && end + 1 < text.size() && starts_name(text[end + 1]))))
      ++end;
    return end - at;
  }
  if (is_digit(text[at])) {
    while (end < text.size() && is_digit(text[end])) ++end;
    return end - at;
  }
  for (const std::string_view sign : long_signs)
    if (text.substr(at, sign.size()) == sign) return sign.size();
  return 1;
}

}  // namespace

RocqToken rocq_token(std::string_view text, std::size_t position) {
  std::size_t at = position;
  while (at < text.size() && is_space(text[at])) ++at;
  if (at == text.size()) return {RocqToken::Kind::end, {}, at, false};
  const RocqToken::Kind kind = starts_name(text[at]) ? RocqToken::Kind::name
                               : is_digit(text[at])  ? RocqToken::Kind::number
                                                     : RocqToken::Kind::sign;
  return {kind, text.substr(at, length_at(text, at)), at, at == position};
}

}  // namespace patchproof
