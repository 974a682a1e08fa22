#include <patchproof/language/keywords.hpp>
#include <patchproof/language/spacing.hpp>

namespace patchproof {
namespace {

bool is_one_of(std::string_view word, std::string_view signs) {
  return word.size() == 1 && signs.find(word) != std::string_view::npos;
}

bool may_have_label(std::string_view keyword) {
  return keyword == "prove" || keyword == "refute" || keyword == "open" || keyword == "derive" ||
         keyword == "assume";
}

}  // namespace

Spacing::Role Spacing::role_of(const Token& token, std::string_view word) const {
  if (token.kind == Token::Kind::name) {
    const bool begins = token.first_on_line && begins_statement(word);
    if (begins || is_inner_keyword(word)) return Role::word;
    // `degree (3, 3)`, `weights [1, 2]`, `knots [0, 1]` are no calls; elsewhere the words are names
    // like others.
    const bool is_degree = word == "degree" && (last_ == ":" || keyword_ == "spline");
    const bool is_part =
        (word == "knots" || word == "weights") && keyword_ == "spline" && last_ == ",";
    return is_degree || is_part ? Role::word : Role::operand;
  }
  if (token.kind != Token::Kind::sign) return Role::operand;
  if (is_one_of(word, "([")) return Role::open;
  if (is_one_of(word, ")]")) return Role::close;
  if (is_one_of(word, "*/^.") || word == "..") return Role::tight;
  if (word == ",") return Role::comma;
  if (word == "?") return Role::operand;
  const bool after_operand = last_role_ == Role::operand || last_role_ == Role::close;
  if (word == "-" && !after_operand) return Role::unary;
  // "south:" is one thing; "C(u) : C^2" are two.
  if (word == ":" && words_ == 2 && may_have_label(keyword_)) return Role::comma;
  return Role::binary;
}

bool Spacing::blank_before(const Token& token) {
  const std::string_view word = text_.substr(token.begin, token.end - token.begin);
  if (token.kind == Token::Kind::name && token.first_on_line && begins_statement(word)) {
    keyword_ = word;
    words_ = 0;
    last_role_ = Role::none;
  }
  const Role role = role_of(token, word);
  const Role last = last_role_;
  last_ = word;
  last_role_ = role;
  ++words_;

  if (last == Role::open || last == Role::unary || last == Role::tight) return false;
  if (role == Role::close || role == Role::tight || role == Role::comma) return false;
  const bool after_operand = last == Role::operand || last == Role::close;
  if (role == Role::open && after_operand) return false;
  return true;
}

}  // namespace patchproof
