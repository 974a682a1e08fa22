#include <patchproof/term/bounded_text.hpp>

#include <algorithm>

namespace patchproof {

BoundedText::BoundedText(std::size_t longest)
    : longest_{std::min(longest, std::string_view::npos / 2)} {}

void BoundedText::put(std::string_view text) {
  if (!full()) text_ += text.substr(0, longest_ + 1 - text_.size());
}

void BoundedText::put_digits(const Integer& number) {
  // The time to write a number grows with the square of its length, so of one that is too long
  // anyway only the first digits. It has more than 3/10 of a digit for every bit.
  const std::size_t bits = number == 0 ? 0 : boost::multiprecision::msb(number);
  const std::size_t digits = bits / 10 * 3;
  if (digits <= longest_ + 1) return put(number.str());
  const unsigned dropped = static_cast<unsigned>(digits - longest_ - 1);
  put(Integer{number / boost::multiprecision::pow(Integer{10}, dropped)}.str());
}

std::string BoundedText::text() const {
  if (!full()) return text_;
  std::size_t end = longest_;
  // UTF-8: the bytes 10xxxxxx continue a character.
  while (end > 0 && (static_cast<unsigned char>(text_[end]) & 0xC0U) == 0x80U) --end;
  return text_.substr(0, end) + "…";
}

}  // namespace patchproof
