#include <algorithm>

#include <patchproof/language/keywords.hpp>
#include <patchproof/language/parser.hpp>
#include <patchproof/language/token_stream.hpp>
#include <patchproof/language/utf8.hpp>

namespace patchproof {
namespace {

constexpr std::size_t most_diagnostics = 20;

std::string nesting_message() {
  return "nested more deeply than " + std::to_string(deepest_nesting) + " levels";
}

}  // namespace

std::string shown(const TokenStream& stream, const Token& token) {
  constexpr std::size_t longest = 40;
  if (token.kind == Token::Kind::end) return "the end of the file";
  std::string_view text = stream.text(token);
  const bool is_quoted = token.kind == Token::Kind::text;
  std::size_t length = 0;
  while (length < text.size() && length < longest) {
    length += std::max<std::size_t>(1, utf8_length(text, length));
  }
  std::string result(text.substr(0, length));
  if (length < text.size()) result += is_quoted ? "...\"" : "...";
  return is_quoted ? result : "'" + result + "'";
}

const Token& TokenStream::token(std::size_t ahead) const {
  return tokens_[std::min(index_ + ahead, tokens_.size() - 1)];
}

std::string_view TokenStream::text(const Token& token) const {
  return std::string_view(source_->text).substr(token.begin, token.end - token.begin);
}

bool TokenStream::is(std::string_view word, std::size_t ahead) const {
  const Token& candidate = token(ahead);
  const bool reads = candidate.kind == Token::Kind::name || candidate.kind == Token::Kind::sign;
  return reads && text(candidate) == word;
}

bool TokenStream::at_statement() const {
  const Token& next = token();
  return next.kind == Token::Kind::end ||
         (next.first_on_line && next.kind == Token::Kind::name && begins_statement(text(next)));
}

bool TokenStream::at_file_item() const {
  return at_end() || (at_statement() && begins_file_item(text()));
}

void TokenStream::advance() {
  if (index_ + 1 < tokens_.size()) ++index_;
}

bool TokenStream::accept(std::string_view word) {
  if (!is(word) || at_statement()) return false;
  advance();
  return true;
}

void TokenStream::expect(std::string_view word) {
  if (!accept(word)) fail_expected("'" + std::string(word) + "'");
}

syntax::Name TokenStream::any_word(std::string_view what) {
  if (!is(Token::Kind::name) || at_statement()) fail_expected(what);
  syntax::Name result{std::string(text()), span(token())};
  advance();
  return result;
}

syntax::Name TokenStream::name(std::string_view what) {
  if (is(Token::Kind::name) && !at_statement() && is_inner_keyword(text())) {
    fail_expected(what, "'" + std::string(text()) + "' is a word of the language");
  }
  return any_word(what);
}

std::vector<syntax::Name> TokenStream::names() {
  std::vector<syntax::Name> result{name()};
  while (accept(",")) result.push_back(name());
  return result;
}

std::string TokenStream::quoted_text() {
  if (!is(Token::Kind::text)) fail_expected("a text in \"...\"");
  const std::string_view quoted = text();
  advance();
  return std::string(quoted.substr(1, quoted.size() - 2));
}

int TokenStream::whole_number(std::string_view what, int low, int high) {
  const std::string_view digits = is(Token::Kind::number) ? text() : "";
  int value = -1;
  if (!digits.empty() && digits.size() < 9 && digits.find('.') == std::string_view::npos) {
    value = std::stoi(std::string(digits));
  }
  if (value < low || value > high) {
    fail_expected(std::string(what) + " from " + std::to_string(low) + " to " +
                  std::to_string(high));
  }
  advance();
  return value;
}

void TokenStream::expect_end_of_statement() {
  const Token& next = token();
  if (next.first_on_line) return;
  if (next.kind == Token::Kind::name && begins_statement(text())) fail_same_line();
  fail_expected("the end of the statement");
}

void TokenStream::fail_same_line() {
  if (is("end")) saw_inline_end_ = true;
  fail(span(token()), "expected a new line before " + shown(*this, token()),
       "every statement begins on a line of its own");
}

Span TokenStream::span_from(std::size_t begin) const {
  const std::size_t end = index_ == 0 ? 0 : tokens_[index_ - 1].end;
  return {source_, begin, std::max(begin, end)};
}

void TokenStream::report(Span span, std::string message, std::string help) {
  if (silent || has_given_up()) return;
  diagnostics_.push_back({std::move(span), std::move(message), std::move(help)});
}

void TokenStream::fail(Span span, std::string message, std::string help) {
  report(std::move(span), std::move(message), std::move(help));
  throw SyntaxError{};
}

void TokenStream::fail_expected(std::string_view what, std::string help) {
  const std::string expected = "expected " + std::string(what);
  const Token& next = token();
  if (next.kind == Token::Kind::bad) throw SyntaxError{};
  if (at_statement() && index_ > 0) {
    // The mistake is where the statement stops, not in the innocent line that follows.
    const std::size_t end = tokens_[index_ - 1].end;
    fail({source_, end, end}, expected + "; the statement ends here", std::move(help));
  }
  fail(span(next), expected + ", found " + shown(*this, next), std::move(help));
}

bool TokenStream::has_given_up() const {
  return has_too_many_statements_ || diagnostics_.size() >= most_diagnostics;
}

void TokenStream::count_statement() {
  if (++statements_ <= most_statements) return;
  report(span(token()), "more than " + std::to_string(most_statements) + " statements in one file");
  has_too_many_statements_ = true;
  throw SyntaxError{};
}

void TokenStream::skip_to_statement() {
  if (has_given_up()) index_ = tokens_.size() - 1;
  while (!at_statement()) advance();
}

void TokenStream::skip_to_file_item() {
  if (has_given_up()) index_ = tokens_.size() - 1;
  while (!at_file_item()) advance();
}

Nested::Nested(TokenStream& stream, Kind kind)
    : stream_(stream), brackets_(kind == Kind::bracket ? 1 : 0) {
  if (stream.levels_ >= deepest_nesting) {
    stream.fail(stream.span(stream.token()), nesting_message());
  }
  ++stream_.levels_;
  stream_.brackets_ += brackets_;
}

Nested::~Nested() {
  --stream_.levels_;
  stream_.brackets_ -= brackets_;
}

}  // namespace patchproof
