#include <memory>
#include <string_view>
#include <vector>

#include <patchproof/language/formatter.hpp>
#include <patchproof/language/keywords.hpp>
#include <patchproof/language/lexer.hpp>
#include <patchproof/language/spacing.hpp>

namespace patchproof {
namespace {

constexpr std::size_t statement_indent = 2;
constexpr std::size_t erratum_indent = 4;
constexpr std::size_t continuation_indent = 4;

/// How far lines are indented, told their first tokens one after the other.
class Indentation {
 public:
  explicit Indentation(std::string_view text) : text_(text) {}

  /// Goes over a token that is not a comment. For the first of a line: the blanks before it.
  std::size_t of(const Token& token) {
    const std::string_view word = text_.substr(token.begin, token.end - token.begin);
    if (token.first_on_line && token.kind == Token::Kind::name && begins_statement(word)) {
      return begin(word);
    }
    const bool is_sign = token.kind == Token::Kind::sign;
    if (is_sign && (word == "(" || word == "[")) ++brackets_;
    if (is_sign && (word == ")" || word == "]")) --brackets_;
    if (is_sign && word == "=" && brackets_ == 0) {
      // The value of a definition is a statement of its own; the '=' of its `let` is not.
      const bool is_value = in_definition_ && !expects_value_;
      expects_value_ = false;
      if (is_value) return statement_ = statement_indent;
    }
    const bool is_part = word == "printed" || word == "corrected" || word == "note";
    if (in_erratum_ && is_part && token.first_on_line) return statement_ = erratum_indent;
    return statement_ + continuation_indent;
  }

  /// What a comment of its own line is indented by, before a line that is indented by `next`.
  std::size_t of_comment_before(std::string_view next_word, std::size_t next) const {
    if (next_word != "end") return next;
    return next == 0 ? statement_indent : erratum_indent;
  }

 private:
  std::size_t begin(std::string_view keyword) {
    brackets_ = 0;
    expects_value_ = keyword == "let";
    if (begins_file_item(keyword)) {
      in_definition_ = keyword == "define";
      in_erratum_ = false;
      statement_ = 0;
    } else if (keyword == "end") {
      statement_ = in_erratum_ ? statement_indent : 0;
      in_erratum_ = false;
    } else {
      in_erratum_ = keyword == "erratum";
      statement_ = statement_indent;
    }
    return statement_;
  }

  std::string_view text_;
  std::size_t statement_ = 0;
  int brackets_ = 0;
  bool in_erratum_ = false;
  bool in_definition_ = false;
  bool expects_value_ = false;
};

/// Writes lines with their indentation; knows how many blank lines go between them.
class Page {
 public:
  /// Begins the line that was line `number` of the source.
  void begin_line(std::size_t number, std::size_t indent) {
    if (!text_.empty()) text_ += number > last_line_ + 1 ? "\n\n" : "\n";
    last_line_ = number;
    text_.append(indent, ' ');
  }
  void add(std::string_view piece) { text_ += piece; }
  bool has_line(std::size_t number) const { return !text_.empty() && last_line_ == number; }
  std::string finished() && {
    if (!text_.empty()) text_ += '\n';
    return std::move(text_);
  }

 private:
  std::string text_;
  std::size_t last_line_ = 0;
};

}  // namespace

std::string formatted(const SourceText& source) {
  const Lexed lexed = tokens_of(std::make_shared<SourceText>(source));
  const std::string_view text = source.text;
  const auto word = [&](const Token& token) {
    return text.substr(token.begin, token.end - token.begin);
  };
  Page page;
  Spacing spacing(text);
  Indentation indentation(text);
  auto comment = lexed.comments.begin();
  for (const Token& token : lexed.tokens) {
    const bool is_end = token.kind == Token::Kind::end;
    const std::size_t indent = is_end ? 0 : indentation.of(token);
    for (; comment != lexed.comments.end() && comment->begin < token.begin; ++comment) {
      if (page.has_line(comment->line)) {
        page.add("  ");
      } else {
        page.begin_line(comment->line, indentation.of_comment_before(word(token), indent));
      }
      page.add(word(*comment));
    }
    if (is_end) break;
    const bool has_blank = spacing.blank_before(token);
    if (token.first_on_line) {
      page.begin_line(token.line, indent);
    } else if (has_blank) {
      page.add(" ");
    }
    page.add(word(token));
  }
  return std::move(page).finished();
}

}  // namespace patchproof
