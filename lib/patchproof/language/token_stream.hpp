#pragma once

// Internal to the parser: the place in the tokens, and how mistakes are reported.

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <patchproof/language/lexer.hpp>
#include <patchproof/language/syntax.hpp>

namespace patchproof {

/// Thrown at the first mistake of a statement, caught where the statement began. By then the
/// diagnostic has been noted.
struct SyntaxError {};

/// How many statements a file may have; beyond that a parser would only fill the memory.
inline constexpr std::size_t most_statements = 100'000;

/// The tokens of a text and a place in them.
class TokenStream {
 public:
  TokenStream(std::shared_ptr<const SourceText> source, const std::vector<Token>& tokens)
      : source_(std::move(source)), tokens_(tokens) {}

  /// The token so many places on; behind the last one there is only the end of the text.
  const Token& token(std::size_t ahead = 0) const;
  std::string_view text(const Token& token) const;
  std::string_view text(std::size_t ahead = 0) const { return text(token(ahead)); }
  /// Whether the token reads so. Never true of texts, comments and bad tokens.
  bool is(std::string_view word, std::size_t ahead = 0) const;
  bool is(Token::Kind kind, std::size_t ahead = 0) const { return token(ahead).kind == kind; }
  std::size_t index() const { return index_; }
  const std::vector<Token>& tokens() const { return tokens_; }

  /// Whether a statement ends before this token: a keyword that is first on its line, or the end.
  bool at_statement() const;
  /// The same of `case`, `define`, `include` and the end.
  bool at_file_item() const;
  bool at_end() const { return is(Token::Kind::end); }

  void advance();
  /// Takes the word or sign if it comes next and does not begin a statement.
  bool accept(std::string_view word);
  /// @throws SyntaxError "expected 'from', found ..."
  void expect(std::string_view word);
  /// A name that is no keyword. @throws SyntaxError "expected a name, found ..."
  syntax::Name name(std::string_view what = "a name");
  /// A name, keyword or not.
  syntax::Name any_word(std::string_view what);
  /// Names with commas between them.
  std::vector<syntax::Name> names();
  /// The contents of "...". @throws SyntaxError "expected a text in \"...\", found ..."
  std::string quoted_text();
  /// @throws SyntaxError "expected a degree from 0 to 99, found ..."
  int whole_number(std::string_view what, int low, int high);
  /// @throws SyntaxError when something follows on the same line.
  void expect_end_of_statement();

  Span span(const Token& token) const { return {source_, token.begin, token.end}; }
  /// From byte `begin` to the end of the last token taken.
  Span span_from(std::size_t begin) const;

  /// "expected a new line before 'prove'", at the present keyword in the middle of a line.
  [[noreturn]] void fail_same_line();
  /// Whether an `end` stood in the middle of a line: what misses its end then is no news.
  bool saw_inline_end() const { return saw_inline_end_; }

  /// Notes a mistake; reading goes on.
  void report(Span span, std::string message, std::string help = "");
  /// Notes a mistake.
  /// @throws SyntaxError always.
  [[noreturn]] void fail(Span span, std::string message, std::string help = "");
  /// "expected an expression, found ')'", at the present token.
  [[noreturn]] void fail_expected(std::string_view what, std::string help = "");
  std::vector<Diagnostic> take_diagnostics() { return std::move(diagnostics_); }

  /// Counts the statement whose keyword comes next.
  /// @throws SyntaxError when there are more than `most_statements`; nothing is read then.
  void count_statement();

  /// Goes to where the next statement begins, or to the end after too many mistakes.
  void skip_to_statement();
  void skip_to_file_item();
  /// Too many mistakes: nothing more is worth reporting.
  bool has_given_up() const;
  /// While true, mistakes are not noted: they follow from one that was.
  bool silent = false;

  /// Names known to be variables rather than functions, for a better help text.
  std::set<std::string, std::less<>> variables;

 private:
  friend class Nested;
  std::shared_ptr<const SourceText> source_;
  const std::vector<Token>& tokens_;
  std::size_t index_ = 0;
  int levels_ = 0;
  int brackets_ = 0;
  bool saw_inline_end_ = false;
  std::size_t statements_ = 0;
  bool has_too_many_statements_ = false;
  std::vector<Diagnostic> diagnostics_;
};

/// One more level of brackets or exponents, for as long as it lives.
class Nested {
 public:
  enum class Kind { bracket, operation };
  /// @throws SyntaxError "nested more deeply than 200 levels"
  Nested(TokenStream& stream, Kind kind);
  ~Nested();
  Nested(const Nested&) = delete;
  Nested& operator=(const Nested&) = delete;

  /// Whether the stream stands inside brackets.
  static bool in_brackets(const TokenStream& stream) { return stream.brackets_ > 0; }

 private:
  TokenStream& stream_;
  int brackets_;
};

/// The word or sign as a message shows it: quoted, and cut when it is long.
std::string shown(const TokenStream& stream, const Token& token);

}  // namespace patchproof
