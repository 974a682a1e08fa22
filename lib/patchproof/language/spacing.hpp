#pragma once

// Internal to the formatter: which tokens have a blank between them.

#include <string_view>

#include <patchproof/language/lexer.hpp>

namespace patchproof {

/// Walks over the tokens of a text without mistakes, one after the other, and says where blanks go.
class Spacing {
 public:
  explicit Spacing(std::string_view text) : text_(text) {}

  /// Whether a blank stands between the token before and this one, if they share a line.
  bool blank_before(const Token& token);

 private:
  /// What a token is for the one after it.
  enum class Role { none, word, operand, open, close, binary, unary, tight, comma };

  Role role_of(const Token& token, std::string_view word) const;

  std::string_view text_;
  std::string_view keyword_;  // of the statement
  std::size_t words_ = 0;     // tokens of the statement so far
  std::string_view last_;     // the token before
  Role last_role_ = Role::none;
};

}  // namespace patchproof
