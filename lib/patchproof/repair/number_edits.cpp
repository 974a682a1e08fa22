#include <patchproof/repair/number_edits.hpp>

#include <algorithm>

#include <patchproof/language/lexer.hpp>

namespace patchproof {

namespace {

constexpr int highest_exponent = 9;

bool is_whole(const Rational& number) { return denominator(number) == 1; }

bool fits(const Rational& number, const Rational& old, NumberPlace place) {
  const bool natural = is_whole(number) && number >= 0;
  if (place == NumberPlace::index) return natural;
  if (place == NumberPlace::exponent)
    return natural && (number <= highest_exponent || abs(number - old) == 1);
  // Below 0 is outside of most ranges.
  return place != NumberPlace::argument || number >= 0;
}

bool follows_sign(const Line& line, std::size_t begin) {
  const std::size_t before =
      begin == 0 ? std::string::npos : line.text.find_last_not_of(' ', begin - 1);
  return before != std::string::npos && (line.text[before] == '-' || line.text[before] == '+');
}

// As it can stand among operators.
std::string as_operand(const Rational& number) {
  const std::string text = to_text(number);
  return number < 0 || !is_whole(number) ? "(" + text + ")" : text;
}

}  // namespace

std::vector<Rational> numbers_in(const Line& line) {
  std::vector<Rational> result;
  const auto source = std::make_shared<const SourceText>(SourceText{"", line.text});
  for (const Token& token : tokens_of(source).tokens)
    if (token.kind == Token::Kind::number)
      if (const auto number =
              number_from_text(line.text.substr(token.begin, token.end - token.begin)))
        result.push_back(*number);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void add_number_edits(const Line& line, const syntax::Expression& number, NumberPlace place,
                      const std::vector<Rational>& others, std::vector<Edit>& edits) {
  const Rational& old = number.number;
  const std::size_t begin = Line::begin_of(number.span);
  std::vector<Rational> values{old - 1, old + 1, 0, 1};
  values.insert(values.end(), others.begin(), others.end());
  // Below a sign, a change of the sign is the same.
  if (!follows_sign(line, begin)) values.push_back(-old);
  for (const Rational& value : values) {
    if (value == old || !fits(value, old, place)) continue;
    edits.push_back({begin, Line::end_of(number.span), as_operand(value),
                     place == NumberPlace::index ? "index" : "number"});
  }
}

}  // namespace patchproof
