#include <patchproof/algebra/enclosure.hpp>

#include <algorithm>
#include <stdexcept>

namespace patchproof {

namespace {

Integer ceiling(const Rational& number) { return -floor(-number); }

Integer power_of_ten(unsigned digits) { return boost::multiprecision::pow(Integer{10}, digits); }

// The digits of scaled / 10^digits, with at least one before the point.
std::string with_point(const Integer& scaled, unsigned digits) {
  std::string text = Integer{boost::multiprecision::abs(scaled)}.str();
  if (text.size() <= digits) text.insert(0, digits + 1 - text.size(), '0');
  if (digits > 0) text.insert(text.size() - digits, ".");
  return (scaled < 0 ? "-" : "") + text;
}

std::string without_final_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

Enclosure exactly(const Rational& number) { return {number, number}; }

bool contains(const Enclosure& enclosure, const Rational& number) {
  return enclosure.low <= number && number <= enclosure.high;
}

Enclosure operator+(const Enclosure& a, const Enclosure& b) {
  return {a.low + b.low, a.high + b.high};
}

Enclosure operator-(const Enclosure& a, const Enclosure& b) {
  return {a.low - b.high, a.high - b.low};
}

Enclosure operator-(const Enclosure& a) { return {-a.high, -a.low}; }

Enclosure operator*(const Enclosure& a, const Enclosure& b) {
  const Rational ends[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  const auto [least, greatest] = std::minmax_element(std::begin(ends), std::end(ends));
  return {*least, *greatest};
}

Enclosure operator/(const Enclosure& a, const Enclosure& b) {
  if (contains(b, 0)) throw std::domain_error{"division by an enclosure that contains zero"};
  return a * Enclosure{1 / b.high, 1 / b.low};
}

Enclosure power(const Enclosure& base, long exponent) {
  if (exponent < 0 && contains(base, 0)) {
    throw std::domain_error{"a negative power of an enclosure that contains zero"};
  }
  const Rational at_low = power(base.low, exponent);
  const Rational at_high = power(base.high, exponent);
  // Without zero inside, a power is monotone, so the ends give the bounds; with zero inside (then
  // the exponent is not negative) an even power has its least value there.
  const bool even = exponent % 2 == 0;
  if (even && exponent != 0 && contains(base, 0)) return {0, std::max(at_low, at_high)};
  return {std::min(at_low, at_high), std::max(at_low, at_high)};
}

Enclosure rounded(const Enclosure& enclosure, unsigned bits) {
  const Rational scale = power(Rational{2}, static_cast<long>(bits));
  return {floor(enclosure.low * scale) / scale, ceiling(enclosure.high * scale) / scale};
}

std::optional<int> sign(const Enclosure& enclosure) {
  if (enclosure.low > 0) return 1;
  if (enclosure.high < 0) return -1;
  if (enclosure.low == 0 && enclosure.high == 0) return 0;
  return std::nullopt;
}

std::string to_decimal(const Enclosure& enclosure, unsigned digits) {
  const Rational scale{power_of_ten(digits)};
  const Rational low = enclosure.low * scale;
  const Rational high = enclosure.high * scale;
  const bool whole = denominator(low) == 1;
  if (low == high && whole) return without_final_zeros(with_point(floor(low), digits));

  // Digits towards zero: what a reader expects of "-0.333…".
  const std::string left = with_point(low < 0 ? ceiling(low) : floor(low), digits);
  const std::string right = with_point(high < 0 ? ceiling(high) : floor(high), digits);
  const std::string minus = enclosure.high < 0 ? "-" : "";
  const std::string a = left.substr(left[0] == '-' ? 1 : 0);
  const std::string b = right.substr(right[0] == '-' ? 1 : 0);
  const std::size_t point = std::min(a.find('.'), a.size());
  const bool same_sign = enclosure.low >= 0 || enclosure.high <= 0;
  std::size_t shared = 0;
  if (a.size() == b.size()) {
    while (shared < a.size() && a[shared] == b[shared]) ++shared;
  }
  // Members of both signs share digits only if all of these are zeros.
  const bool all_zeros = a.find_first_not_of("0.") >= shared;
  const std::size_t least = digits == 0 ? point : point + 2;
  if (shared >= least && (same_sign || (all_zeros && digits > 0))) {
    return minus + a.substr(0, shared) + "…";
  }
  return "[" + without_final_zeros(with_point(floor(low), digits)) + ", " +
         without_final_zeros(with_point(ceiling(high), digits)) + "]";
}

}  // namespace patchproof
