#include <patchproof/figure/decimal.hpp>

namespace patchproof {

std::string decimal(const Rational& number, unsigned digits) {
  Integer unit = 1;
  for (unsigned k = 0; k < digits; ++k) unit *= 10;
  const bool negative = number < 0;
  const Rational scaled = (negative ? Rational{-number} : number) * unit + Rational{1, 2};
  const Integer units = floor(scaled);
  std::string text = units.str();
  if (text.size() <= digits) text.insert(0, digits + 1 - text.size(), '0');
  if (digits > 0) {
    text.insert(text.size() - digits, ".");
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return negative && text != "0" ? "-" + text : text;
}

Rational rounded(const Rational& number, unsigned bits) {
  const Rational unit = power(Rational{2}, static_cast<long>(bits));
  const Rational scaled = number * unit + Rational{1, 2};
  return Rational{floor(scaled)} / unit;
}

}  // namespace patchproof
