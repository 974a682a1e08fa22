#include <patchproof/latex/plain_latex.hpp>

#include <algorithm>
#include <cctype>
#include <map>

#include <patchproof/language/utf8.hpp>
#include <patchproof/term/latex_name.hpp>

namespace patchproof {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

class Translation {
 public:
  Translation(const std::string& text, const Notation& notation)
      : text_{text}, notation_{notation} {}

  std::string result() {
    while (at_ < text_.size()) next();
    return std::move(result_);
  }

 private:
  char after(std::size_t k) const { return at_ + k < text_.size() ? text_[at_ + k] : '\0'; }

  void next() {
    const char c = text_[at_];
    if (is_digit(c)) return number();
    if (is_letter(c)) return name();
    if (c == '^') return exponent();
    for (const auto& [sign, latex] : signs()) {
      if (text_.compare(at_, sign.size(), sign) != 0) continue;
      result_ += latex;
      at_ += sign.size();
      return;
    }
    // No letter of a formula: words of some language.
    if (static_cast<unsigned char>(c) >= 0x80U) {
      const std::size_t length = std::max<std::size_t>(1, utf8_length(text_, at_));
      result_ += "\\mbox{" + text_.substr(at_, length) + "}";
      at_ += length;
      return;
    }
    ++at_;
    // Between factors nothing is written, but where two numbers would meet.
    if (c == '*')
      result_ += is_digit(after(0))                          ? " \\cdot "
                 : result_.ends_with(')') || after(0) == '(' ? ""
                                                             : "\\,";
    else if (c == '#' || c == '$' || c == '%' || c == '&' || c == '{' || c == '}' || c == '~' ||
             c == '\\')
      result_ += "\\mbox{" + latex_escaped(std::string(1, c)) + "}";
    else
      result_ += c;
  }

  static const std::map<std::string, std::string>& signs() {
    static const std::map<std::string, std::string> table{
        {"!=", "\\neq"}, {"<=", "\\leq"}, {">=", "\\geq"}, {"==", "="}, {"…", "\\dots "}};
    return table;
  }

  std::string digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  void number() {
    const std::string above = digits();
    // "-1*u" is -u.
    const bool after_number =
        !result_.empty() && (is_digit(result_.back()) || result_.back() == '}');
    if (above == "1" && after(0) == '*' && !is_digit(after(1)) && !after_number) {
      ++at_;
      return;
    }
    if (after(0) == '/' && is_digit(after(1))) {
      ++at_;
      result_ += "\\tfrac{" + above + "}{" + digits() + "}";
    } else {
      result_ += above;
    }
  }

  void exponent() {
    ++at_;
    if (after(0) == '-' && is_digit(after(1))) {
      ++at_;
      result_ += "^{-" + digits() + "}";
    } else if (is_digit(after(0))) {
      result_ += "^{" + digits() + "}";
    } else {
      result_ += "^";
    }
  }

  void name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '_'))
      ++at_;
    const std::string word = text_.substr(begin, at_ - begin);
    if (word == "sin" || word == "cos") {
      result_ += "\\" + word;
      return;
    }
    if (word == "pi" && after(0) != '[') {
      result_ += "\\pi";
      return;
    }
    if (word == "sqrt" && after(0) == '(') return root();
    result_ += latex_name(word + indices(), notation_).text();
  }

  // "[0,2]"; "" where something else than numbers stands between the brackets.
  std::string indices() {
    if (after(0) != '[') return "";
    const std::size_t end = text_.find(']', at_);
    if (end == std::string::npos) return "";
    const std::string inside = text_.substr(at_, end - at_ + 1);
    if (inside.size() < 3 || inside.find_first_not_of("0123456789,[]") != std::string::npos)
      return "";
    at_ = end + 1;
    return inside;
  }

  void root() {
    int depth = 0;
    for (std::size_t k = at_; k < text_.size(); ++k) {
      if (text_[k] == '(') ++depth;
      if (text_[k] != ')' || --depth > 0) continue;
      result_ += "\\sqrt{" + plain_latex(text_.substr(at_ + 1, k - at_ - 1), notation_) + "}";
      at_ = k + 1;
      return;
    }
    result_ += "\\surd ";
  }

  const std::string& text_;
  const Notation& notation_;
  std::size_t at_ = 0;
  std::string result_;
};

}  // namespace

std::string plain_latex(const std::string& text, const Notation& notation) {
  return Translation{text, notation}.result();
}

}  // namespace patchproof
