#include <patchproof/figure/decimal.hpp>

namespace patchproof {

namespace {

// The greatest whole number that is not above the fraction; the divisor is positive.
Integer floor_of(const Integer& dividend, const Integer& divisor) {
  Integer result = dividend / divisor;
  if (dividend < 0 && result * divisor != dividend) --result;
  return result;
}

}  // namespace

std::string decimal(const Rational& number, unsigned digits) {
  Integer unit = 1;
  for (unsigned k = 0; k < digits; ++k) unit *= 10;
  const bool negative = number < 0;
  const Rational scaled = (negative ? Rational{-number} : number) * unit + Rational{1, 2};
  const Integer units = floor_of(numerator(scaled), denominator(scaled));
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
  const Integer unit = Integer{1} << bits;
  const Rational scaled = number * unit + Rational{1, 2};
  return Rational{floor_of(numerator(scaled), denominator(scaled)), unit};
}

}  // namespace patchproof
