#include <patchproof/net/exact_number.hpp>
#include <patchproof/net/json_tokens.hpp>
#include <patchproof/net/net_fault.hpp>

namespace patchproof {

namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }

bool is_blank(int c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

bool is_of_bare_token(unsigned char c) {
  return c > ' ' && c != ',' && c != ']' && c != '}' && c != '[' && c != '{' && c != ':' &&
         c != '"';
}

bool is_of_text(unsigned char c) { return c >= ' ' && c != '"' && c != '\\'; }

/// RFC 8259, section 6: [ - ] int [ frac ] [ exp ].
bool is_json_number(std::string_view text) {
  std::size_t at = text.starts_with('-') ? 1 : 0;
  const auto digits = [&] {
    const std::size_t from = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return at - from;
  };
  const bool zero = text.substr(at).starts_with('0');
  const std::size_t whole = digits();
  if (whole == 0 || (zero && whole > 1)) return false;
  if (at < text.size() && text[at] == '.') {
    ++at;
    if (digits() == 0) return false;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    if (digits() == 0) return false;
  }
  return at == text.size();
}

}  // namespace

std::size_t JsonTokens::next() {
  while (is_blank(bytes_.peek())) bytes_.advance();
  return bytes_.offset();
}

bool JsonTokens::is(char sign) {
  next();
  return bytes_.peek() == static_cast<unsigned char>(sign);
}

bool JsonTokens::accept(char sign) {
  if (!is(sign)) return false;
  begin_ = bytes_.offset();
  bytes_.advance();
  end_ = bytes_.offset();
  return true;
}

void JsonTokens::expect(char sign, const std::string& what) {
  if (!accept(sign)) fail_expected(what);
}

bool JsonTokens::more(char close) {
  if (accept(',')) return true;
  if (!accept(close)) fail_expected("',' or '" + std::string(1, close) + "'");
  return false;
}

void JsonTokens::fail_expected(const std::string& what) {
  const std::size_t at = next();
  const int c = bytes_.peek();
  if (c == ByteReader::end_of_text)
    throw NetFault{at, at, "expected " + what + ", found the end of the text"};
  std::string found = "'" + std::string(1, static_cast<char>(c)) + "'";
  std::size_t length = 1;
  if (c == '"') {
    found = "a text";
  } else if (is_of_bare_token(static_cast<unsigned char>(c))) {
    const std::string_view token = bytes_.take_while(is_of_bare_token, 40);
    found = "'" + std::string{token} + "'";
    length = token.size();
  }
  throw NetFault{at, at + length, "expected " + what + ", found " + found};
}

Rational JsonTokens::number() {
  begin_ = next();
  if (bytes_.peek() == '"') {
    const std::string_view text = quoted(longest_coordinate + 1);
    return exact_number(text, begin_ + 1);
  }
  const std::string_view token = bytes_.take_while(is_of_bare_token, longest_coordinate + 1);
  end_ = begin_ + token.size();
  if (token.empty()) fail_expected("a number");
  const Rational value = exact_number(token, begin_);
  if (!is_json_number(token))
    throw NetFault{begin_, end_, "'" + std::string{token.substr(0, 40)} + "' is no number of JSON",
                   "put it in quotes: \"" + std::string{token.substr(0, 40)} + "\""};
  return value;
}

int JsonTokens::whole(const std::string& what, int low, int high) {
  const Rational value = number();
  if (!value.is_small() || value.words().denominator != 1 || value < Rational{low} ||
      value > Rational{high})
    throw NetFault{
        begin_, end_,
        what + " is a whole number from " + std::to_string(low) + " to " + std::to_string(high)};
  return static_cast<int>(value.words().numerator);
}

std::string_view JsonTokens::quoted(std::size_t most) {
  begin_ = next();
  bytes_.advance();
  // A copy: the closing quote may stand in the next block.
  text_.assign(bytes_.take_while(is_of_text, most));
  end_ = begin_ + 1 + text_.size();
  if (text_.size() == most) return text_;
  if (bytes_.peek() != '"')
    throw NetFault{begin_, end_,
                   bytes_.peek() == '\\' ? "an escape where a number or a name stands"
                                         : "a text without its closing '\"'"};
  bytes_.advance();
  ++end_;
  return text_;
}

std::string JsonTokens::name() {
  constexpr std::size_t longest = 100;
  if (!is('"')) fail_expected("a name in quotes");
  const std::string result{quoted(longest)};
  if (result.size() == longest) throw NetFault{begin_, end_, "a name with more than 99 characters"};
  return result;
}

void JsonTokens::skip_text() {
  if (!is('"')) fail_expected("a text in quotes");
  begin_ = bytes_.offset();
  bytes_.advance();
  for (;;) {
    const int c = bytes_.peek();
    if (c == ByteReader::end_of_text || c == '\n')
      throw NetFault{begin_, bytes_.offset(), "a text without its closing '\"'"};
    bytes_.advance();
    if (c == '"') break;
    if (c == '\\' && bytes_.peek() != ByteReader::end_of_text) bytes_.advance();
  }
  end_ = bytes_.offset();
}

void JsonTokens::expect_end() {
  next();
  if (bytes_.peek() != ByteReader::end_of_text) fail_expected("the end of the text");
}

}  // namespace patchproof
