#include <patchproof/repair/sign_edits.hpp>

#include <patchproof/language/lexer.hpp>

namespace patchproof {

std::vector<Edit> sign_edits(const Line& line, const Span& part) {
  std::vector<Edit> result;
  const auto source = std::make_shared<const SourceText>(SourceText{"", line.text});
  bool after_operand = false;
  for (const Token& token : tokens_of(source).tokens) {
    const std::string word = line.text.substr(token.begin, token.end - token.begin);
    const bool inside = Line::begin_of(part) <= token.begin && token.end <= Line::end_of(part);
    if (inside && (word == "+" || word == "-")) {
      const std::string other = after_operand ? (word == "+" ? "-" : "+") : "";
      result.push_back({token.begin, token.end, other, "sign"});
    }
    after_operand = token.kind == Token::Kind::number || token.kind == Token::Kind::name ||
                    word == ")" || word == "]";
  }
  return result;
}

}  // namespace patchproof
