#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <optional>
#include <string>

#include <patchproof/algebra/number.hpp>
#include <patchproof/net/exact_number.hpp>
#include <patchproof/net/net_fault.hpp>

namespace patchproof {

namespace {

/// So many digits fit a word whatever they are.
constexpr std::size_t digits_in_word = 18;

constexpr std::size_t hexadecimal_digits_in_word = 15;

constexpr std::array<std::int64_t, digits_in_word + 1> powers_of_ten = [] {
  std::array<std::int64_t, digits_in_word + 1> powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = powers[k - 1] * 10;
  return powers;
}();

bool is_digit(char c) { return '0' <= c && c <= '9'; }

int hexadecimal_digit(char c) {
  if (is_digit(c)) return c - '0';
  if ('a' <= c && c <= 'f') return c - 'a' + 10;
  if ('A' <= c && c <= 'F') return c - 'A' + 10;
  return -1;
}

class Token {
 public:
  Token(std::string_view text, std::size_t at) : text_{text}, begin_{at} {}

  Rational value() {
    if (text_.size() > longest_coordinate)
      fail("a number with more than " + std::to_string(longest_coordinate) + " characters");
    const bool negative = is("-");
    if (negative || is("+")) ++at_;
    Rational magnitude = is("0x") || is("0X") ? hexadecimal() : decimal();
    if (at_ != text_.size()) fail_as_unreadable();
    return negative ? -magnitude : magnitude;
  }

 private:
  [[noreturn]] void fail(const std::string& message, const std::string& help = "") const {
    throw NetFault{begin_, begin_ + text_.size(), message, help};
  }

  [[noreturn]] void fail_as_unreadable() const {
    std::string lower;
    for (const char c : text_.substr(0, 10))
      if (c != '-' && c != '+')
        lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (lower.starts_with("nan") || lower.starts_with("inf"))
      fail("'" + std::string{text_.substr(0, 20)} + "' is not a point of any patch",
           "nets have finite, exact coordinates");
    const bool cut = text_.size() > 40;
    fail("expected a number, found '" + std::string{text_.substr(0, 40)} + (cut ? "..." : "") + "'",
         "a decimal like -0.25e-3, a fraction like 1/3, or a hexadecimal number like 0x1.8p-3");
  }

  bool is(std::string_view start) const { return text_.substr(at_).starts_with(start); }
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string_view digits() {
    const std::size_t from = at_;
    while (is_digit(next())) ++at_;
    return text_.substr(from, at_ - from);
  }

  /// A whole number with sign, not beyond `largest` either way.
  int exponent(int largest) {
    const bool negative = next() == '-';
    if (negative || next() == '+') ++at_;
    const std::string_view written = digits();
    if (written.empty()) fail_as_unreadable();
    const std::string_view significant =
        written.substr(std::min(written.find_first_not_of('0'), written.size()));
    const int value = significant.size() > 9 ? largest + 1 : word(significant);
    if (value > largest)
      fail("an exponent beyond " + std::to_string(largest),
           "numbers this large or small are not read; change the unit of the coordinates");
    return negative ? -value : value;
  }

  static int word(std::string_view digits) {
    int value = 0;
    for (const char digit : digits) value = value * 10 + (digit - '0');
    return value;
  }

  /// Digits, a point, digits, and an exponent of ten; or a fraction.
  Rational decimal() {
    const std::string_view whole = digits();
    if (next() == '/') return fraction(whole);
    std::string_view behind;
    if (next() == '.') {
      ++at_;
      behind = digits();
    }
    if (whole.empty() && behind.empty()) fail_as_unreadable();
    const bool has_exponent = next() == 'e' || next() == 'E';
    if (!has_exponent && whole.size() + behind.size() <= digits_in_word)
      return small_decimal(whole, behind);
    Rational value = *number_from_text(std::string{whole.empty() ? "0" : whole} +
                                       (behind.empty() ? "" : "." + std::string{behind}));
    if (!has_exponent) return value;
    ++at_;
    return value * power(Rational{10}, exponent(largest_decimal_exponent));
  }

  static Rational small_decimal(std::string_view whole, std::string_view behind) {
    std::int64_t mantissa = 0;
    for (const char digit : whole) mantissa = mantissa * 10 + (digit - '0');
    for (const char digit : behind) mantissa = mantissa * 10 + (digit - '0');
    if (behind.empty()) return Rational{mantissa};
    return Rational{mantissa, powers_of_ten[behind.size()]};
  }

  Rational fraction(std::string_view top) {
    if (top.empty()) fail_as_unreadable();
    ++at_;
    const std::string_view bottom = digits();
    if (bottom.empty() || at_ != text_.size()) fail_as_unreadable();
    const Rational denominator = *number_from_text(bottom);
    if (denominator.sign() == 0) fail("a denominator that is 0");
    return *number_from_text(top) / denominator;
  }

  /// Behind "0x": digits, a point, digits, and an exponent of two.
  Rational hexadecimal() {
    at_ += 2;
    // The digits of a number of 64 bits with floating point fit a word.
    std::uint64_t word = 0;
    Integer mantissa = 0;
    int binary_digits_behind = 0;
    bool behind = false;
    std::size_t count = 0;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '.' && !behind) {
        behind = true;
        continue;
      }
      const int digit = hexadecimal_digit(text_[at_]);
      if (digit < 0) break;
      if (count < hexadecimal_digits_in_word) {
        word = word * 16 + static_cast<std::uint64_t>(digit);
      } else {
        if (count == hexadecimal_digits_in_word) mantissa = word;
        mantissa = mantissa * 16 + digit;
      }
      binary_digits_behind += behind ? 4 : 0;
      ++count;
    }
    if (count == 0) fail_as_unreadable();
    int scale = -binary_digits_behind;
    if (next() == 'p' || next() == 'P') {
      ++at_;
      scale += exponent(largest_binary_exponent);
    }
    if (count > hexadecimal_digits_in_word) return Rational{mantissa} * power(Rational{2}, scale);
    const auto whole = static_cast<std::int64_t>(word);
    if (-62 <= scale && scale <= 0) return Rational{whole, std::int64_t{1} << -scale};
    return Rational{whole} * power(Rational{2}, scale);
  }

  std::string_view text_;
  std::size_t begin_;
  std::size_t at_ = 0;
};

}  // namespace

Rational exact_number(std::string_view token, std::size_t at) { return Token{token, at}.value(); }

}  // namespace patchproof
