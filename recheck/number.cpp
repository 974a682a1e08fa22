#include <recheck/number.hpp>

namespace recheck {

namespace {

constexpr std::size_t longest = 10'000;

// Zeros in front would make Boost read the digits as octal.
bool is_whole(std::string_view text) {
  if (text.empty() || (text.size() > 1 && text.front() == '0')) return false;
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

std::optional<Rational> number_of(std::string_view text) {
  if (text.size() > longest) return std::nullopt;
  const bool negative = text.starts_with('-');
  const std::string_view digits = text.substr(negative ? 1 : 0);
  const std::size_t bar = digits.find('/');
  const std::string_view above = digits.substr(0, bar);
  const std::string_view below =
      bar == std::string_view::npos ? std::string_view{"1"} : digits.substr(bar + 1);
  if (!is_whole(above) || !is_whole(below) || below == "0") return std::nullopt;
  const Rational size{Integer{std::string{above}}, Integer{std::string{below}}};
  const Rational number = negative ? Rational{-size} : size;
  // One number has one text: -0, 2/4 and 3/1 are none.
  if (to_text(number) != text) return std::nullopt;
  return number;
}

std::string to_text(const Rational& number) { return number.str(); }

std::size_t extra_words(const Rational& number) {
  const auto of = [](const Integer& whole) { return std::size_t{whole.backend().size()}; };
  return of(numerator(number)) + of(denominator(number)) - 2;
}

// Newton's method from above: the first value that does not fall is the answer.
Integer floor_of_root(const Integer& number) {
  if (number == 0) return 0;
  Integer root = 1;
  root <<= static_cast<unsigned>(msb(number)) / 2 + 1;
  for (;;) {
    Integer next = number;
    next /= root;
    next += root;
    next /= 2;
    if (next >= root) return root;
    root.swap(next);
  }
}

}  // namespace recheck
