#include <array>
#include <charconv>

#include <patchproof/algebra/number.hpp>
#include <patchproof/net/net_writer.hpp>

namespace patchproof {

namespace {

void append_word(std::int64_t value, std::string& text) {
  std::array<char, 24> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), result.ptr);
}

void append_list(const std::vector<Rational>& numbers, std::string& text) {
  text += '[';
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (k > 0) text += ", ";
    append_json_number(numbers[k], text);
  }
  text += ']';
}

}  // namespace

void append_number(const Rational& number, std::string& text) {
  if (!number.is_small()) {
    text += to_text(number);
    return;
  }
  const Rational::Words words = number.words();
  append_word(words.numerator, text);
  if (words.denominator == 1) return;
  text += '/';
  append_word(words.denominator, text);
}

void append_json_number(const Rational& number, std::string& text) {
  const bool whole = number.is_small() ? number.words().denominator == 1 : denominator(number) == 1;
  if (!whole) text += '"';
  append_number(number, text);
  if (!whole) text += '"';
}

std::string net_as_csv(const PointNet& net) {
  std::string text;
  for (std::size_t i = 0; i < net.rows; ++i) {
    for (std::size_t j = 0; j < net.columns; ++j) {
      for (std::size_t k = 0; k < net.dimension; ++k) {
        if (k > 0) text += ',';
        append_number(net.coordinate(i, j, k), text);
      }
      text += '\n';
    }
    text += '\n';
  }
  return text;
}

std::string net_as_json(const PointNet& net) {
  std::string text = "{";
  if (net.degrees)
    text += "\"degrees\": [" + std::to_string((*net.degrees)[0]) + ", " +
            std::to_string((*net.degrees)[1]) + "],\n ";
  if (net.knots) {
    text += "\"knots\": [";
    append_list((*net.knots)[0], text);
    text += ",\n           ";
    append_list((*net.knots)[1], text);
    text += "],\n ";
  }
  text += "\"points\": [";
  for (std::size_t i = 0; i < net.rows; ++i) {
    text += i == 0 ? "\n  [" : ",\n  [";
    for (std::size_t j = 0; j < net.columns; ++j) {
      text += j == 0 ? "[" : ", [";
      for (std::size_t k = 0; k < net.dimension; ++k) {
        if (k > 0) text += ", ";
        append_json_number(net.coordinate(i, j, k), text);
      }
      text += ']';
    }
    text += ']';
  }
  return text + "]}\n";
}

}  // namespace patchproof
