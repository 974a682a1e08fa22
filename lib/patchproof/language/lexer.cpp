#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <patchproof/algebra/number.hpp>
#include <patchproof/language/lexer.hpp>
#include <patchproof/language/utf8.hpp>

namespace patchproof {
namespace {

constexpr std::size_t most_diagnostics = 20;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// What to write instead of a character that looks right in a textbook.
std::string replacement_for(std::string_view character) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 24> table{{
      {"−", "write '-'"},
      {"–", "write '-'"},
      {"·", "write '*'"},
      {"×", "write '*'"},
      {"⋅", "write '*'"},
      {"∗", "write '*'"},
      {"÷", "write '/'"},
      {"≤", "write '<='"},
      {"≥", "write '>='"},
      {"≠", "write '!='"},
      {"!", "'not equal' is written '!='"},
      {"≡", "write '=='"},
      {"²", "write '^2'"},
      {"³", "write '^3'"},
      {"√", "write 'sqrt(...)'"},
      {"π", "write 'pi'"},
      {"…", "a range is written '..', as in 0..3"},
      {"′", "a derivative is written with ', as in C1'(0)"},
      {"’", "a derivative is written with ', as in C1'(0)"},
      {"“", "a text is written \"...\""},
      {"”", "a text is written \"...\""},
      {"„", "a text is written \"...\""},
      {"\xC2\xA0", "this is a no-break space; use a plain one"},
      {"_", "a name begins with a letter"},
  }};
  for (const auto& [written, help] : table) {
    if (written == character) return std::string(help);
  }
  const bool is_ascii = static_cast<unsigned char>(character.front()) < 0x80;
  return is_ascii ? "" : "names are made of the letters a-z, A-Z, digits, '_' and trailing quotes";
}

class Lexer {
 public:
  explicit Lexer(const std::shared_ptr<const SourceText>& source)
      : source_(source), text_(source->text) {}

  Lexed run() {
    if (!is_text()) return std::move(result_);
    check_encoding();
    if (text_.substr(0, byte_order_mark.size()) == byte_order_mark) at_ = byte_order_mark.size();
    while (at_ < text_.size() && result_.readable) next();
    token(Token::Kind::end, text_.size());
    result_.tokens.back().first_on_line = true;
    return std::move(result_);
  }

 private:
  void report(std::size_t begin, std::size_t end, std::string message, std::string help = "") {
    if (result_.diagnostics.size() >= most_diagnostics) return;
    result_.diagnostics.push_back({{source_, begin, end}, std::move(message), std::move(help)});
  }

  /// Reports the first byte no text has.
  bool is_text() {
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const unsigned byte = static_cast<unsigned char>(text_[i]);
      const bool is_control = byte < 0x20 && byte != '\n' && byte != '\t' && byte != '\r';
      if (!is_control && byte != 0x7F) continue;
      report(i, i + 1, "this is not a text file");
      result_.readable = false;
      return false;
    }
    return true;
  }

  /// Reports invalid UTF-8, once a line: a text in another encoding is one mistake.
  void check_encoding() {
    bool reported = false;
    for (std::size_t i = 0; i < text_.size();) {
      if (text_[i] == '\n') reported = false;
      const std::size_t length = utf8_length(text_, i);
      if (length == 0 && !reported) {
        report(i, i + 1, "invalid UTF-8", "save the file in the encoding UTF-8");
        reported = true;
      }
      i += std::max<std::size_t>(1, length);
    }
  }

  void next() {
    const char c = text_[at_];
    if (c == '\n') {
      ++line_;
      ++at_;
      first_on_line_ = true;
    } else if (is_blank(c)) {
      ++at_;
    } else if (c == '#') {
      comment();
    } else if (is_letter(c)) {
      name();
    } else if (is_digit(c)) {
      number();
    } else if (c == '"') {
      quoted_text();
    } else if (const std::size_t length = sign_length(at_); length > 0) {
      token(Token::Kind::sign, at_ + length);
    } else {
      stray();
    }
  }

  void token(Token::Kind kind, std::size_t end) {
    if (result_.tokens.size() == most_tokens && kind != Token::Kind::end) {
      report(at_, end, "more than " + std::to_string(most_tokens) + " words and signs in one file");
      result_.readable = false;
      return;
    }
    result_.tokens.push_back({kind, first_on_line_, line_, at_, end});
    first_on_line_ = false;
    at_ = end;
  }

  void comment() {
    std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::size_t next = end;
    while (is_blank(text_[end - 1])) --end;  // stops at the '#'
    result_.comments.push_back({Token::Kind::comment, first_on_line_, line_, at_, end});
    at_ = next;
  }

  void name() {
    std::size_t end = at_;
    const auto here = [&] { return end < text_.size() ? text_[end] : '\0'; };
    while (is_letter(here()) || is_digit(here()) || here() == '_') ++end;
    while (here() == '\'') ++end;
    token(Token::Kind::name, end);
  }

  void number() {
    std::size_t end = at_;
    const auto digit_at = [&](std::size_t i) { return i < text_.size() && is_digit(text_[i]); };
    while (digit_at(end)) ++end;
    // "0..3" is a range and "1.x" a component: a point belongs to a number only before a digit.
    if (end < text_.size() && text_[end] == '.' && digit_at(end + 1)) {
      ++end;
      while (digit_at(end)) ++end;
    }
    if (end - at_ > longest_number) {
      report(at_, end, "number with more than " + std::to_string(longest_number) + " characters");
      token(Token::Kind::bad, end);
    } else {
      token(Token::Kind::number, end);
    }
  }

  void quoted_text() {
    std::size_t end = std::min(text_.find_first_of("\"\n", at_ + 1), text_.size());
    if (end < text_.size() && text_[end] == '"') {
      token(Token::Kind::text, end + 1);
      return;
    }
    while (is_blank(text_[end - 1])) --end;
    report(at_, end, "text without a closing '\"'", "a text is written on one line");
    token(Token::Kind::bad, end);
  }

  std::size_t sign_length(std::size_t at) const {
    static constexpr std::array<std::string_view, 5> pairs{"..", "==", "!=", "<=", ">="};
    if (std::find(pairs.begin(), pairs.end(), text_.substr(at, 2)) != pairs.end()) return 2;
    constexpr std::string_view singles = "+-*/^()[],;:=<>?.";
    return singles.find(text_[at]) == std::string_view::npos ? 0 : 1;
  }

  /// A run of characters that mean nothing is one mistake.
  void stray() {
    const auto is_stray = [&](std::size_t at) {
      const char c = text_[at];
      return c != '\n' && !is_blank(c) && c != '#' && !is_letter(c) && !is_digit(c) && c != '"' &&
             sign_length(at) == 0;
    };
    const std::size_t length = utf8_length(text_, at_);
    std::size_t end = at_ + std::max<std::size_t>(1, length);
    if (length > 0) {  // otherwise it has been reported as invalid UTF-8
      const std::string_view character = text_.substr(at_, length);
      report(at_, end, "stray character '" + std::string(character) + "'",
             replacement_for(character));
    }
    while (end < text_.size() && is_stray(end)) ++end;
    token(Token::Kind::bad, end);
  }

  std::shared_ptr<const SourceText> source_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
  bool first_on_line_ = true;
  Lexed result_;
};

}  // namespace

Lexed tokens_of(const std::shared_ptr<const SourceText>& source) { return Lexer(source).run(); }

}  // namespace patchproof
