#include <patchproof/language/implicit_product.hpp>
#include <patchproof/language/keywords.hpp>
#include <patchproof/language/nearest_name.hpp>

namespace patchproof {
namespace {

using Kind = Token::Kind;

constexpr std::size_t most_pieces = 24;  // tokens; a longer product would not be read anyway

/// The tokens [first, last] of the faulty product, written with every '*' in its place.
class Rewriting {
 public:
  Rewriting(const TokenStream& stream, std::size_t first) : stream_(stream), at_(first) {}

  /// Empty when the product is not simple.
  std::string run() {
    factor();
    while (simple_ && continues()) {
      const std::string_view next = stream_.text(token());
      if (next == "*" || next == "/" || next == "^") {
        take();
      } else {
        result_ += '*';
      }
      factor();
    }
    return simple_ ? result_ : "";
  }

 private:
  const Token& token() const { return stream_.tokens()[at_]; }

  bool continues() const {
    const Token& next = token();
    if (next.first_on_line) return false;
    const std::string_view text = stream_.text(next);
    if (next.kind == Kind::name) return !is_inner_keyword(text);
    return next.kind == Kind::number ||
           (next.kind == Kind::sign && (text == "(" || text == "*" || text == "/" || text == "^"));
  }

  void take() {
    result_ += stream_.text(token());
    ++at_;
    if (++taken_ > most_pieces) simple_ = false;
  }

  /// A number, a name with its arguments, or something in parentheses.
  void factor() {
    const Token& next = token();
    if (next.kind == Kind::number) {
      take();
    } else if (next.kind == Kind::name) {
      const bool is_variable = stream_.variables.count(stream_.text(next)) > 0;
      take();
      if (!is_variable && !token().first_on_line && stream_.text(token()) == "(") brackets();
    } else if (stream_.text(next) == "(") {
      brackets();
    } else {
      simple_ = false;
    }
  }

  /// From '(' to its ')', as written.
  void brackets() {
    int open = 0;
    bool after_operand = false;
    do {
      const Token& next = token();
      const std::string_view text = stream_.text(next);
      const bool is_word = next.kind == Kind::number || next.kind == Kind::name;
      if (next.kind == Kind::end || next.kind == Kind::bad || next.first_on_line ||
          (is_word && after_operand)) {
        simple_ = false;
      }
      if (!simple_) return;
      after_operand = is_word || text == ")";
      if (text == "(") ++open;
      if (text == ")") --open;
      if (text == ",") {
        result_ += ", ";
        ++at_;
      } else {
        take();
      }
    } while (open > 0);
  }

  const TokenStream& stream_;
  std::size_t at_;
  std::size_t taken_ = 0;
  bool simple_ = true;
  std::string result_;
};

/// Where the operand that ends before the present token begins.
std::size_t operand_before(const TokenStream& stream) {
  std::size_t first = stream.index() - 1;
  const auto text = [&](std::size_t index) { return stream.text(stream.tokens()[index]); };
  if (text(first) == ")") {
    int open = 0;
    for (std::size_t steps = 0; steps < most_pieces; ++steps, --first) {
      if (text(first) == ")") ++open;
      if (text(first) == "(" && --open == 0) break;
      if (first == 0) break;
    }
    if (first > 0 && stream.tokens()[first - 1].kind == Kind::name) --first;
  }
  return first;
}

}  // namespace

std::string missing_operator_help(const TokenStream& stream) {
  const std::string_view word = stream.text();
  if (stream.is(Kind::name) && word.size() >= 4) {
    const std::string near = did_you_mean(word, inner_keywords());
    if (!near.empty()) return near;
  }
  const std::string general = "multiplication is written '*'";
  const std::string product = Rewriting(stream, operand_before(stream)).run();
  return product.empty() ? general : general + ": " + product;
}

}  // namespace patchproof
