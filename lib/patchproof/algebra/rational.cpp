#include <patchproof/algebra/rational.hpp>

#include <numeric>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace patchproof {

namespace {

bool fits(const Integer& whole, std::int64_t largest) { return whole <= largest && whole >= -largest; }

}  // namespace

Rational::Rational(const Integer& whole) {
  if (fits(whole, largest))
    numerator_ = whole.convert_to<std::int64_t>();
  else
    set_large(Large{whole});
}

Rational::Rational(const Integer& numerator, const Integer& denominator) {
  if (denominator == 0) throw std::overflow_error{"division by zero"};
  // Boost takes a negative denominator without bounds for one that cannot be turned.
  set_large(denominator < 0 ? Large{Integer{-numerator}, Integer{-denominator}}
                            : Large{numerator, denominator});
}

Rational& Rational::operator=(const Rational& other) {
  if (this == &other) return *this;
  if (other.large_ || large_)
    large_ = other.large_ ? std::make_unique<Large>(*other.large_) : nullptr;
  numerator_ = other.numerator_;
  denominator_ = other.denominator_;
  return *this;
}

Rational::Large Rational::large() const {
  return large_ ? *large_ : Large{numerator_, denominator_};
}

void Rational::set_large(Large&& value) {
  const Integer top = boost::multiprecision::numerator(value);
  const Integer bottom = boost::multiprecision::denominator(value);
  if (fits(top, largest) && fits(bottom, largest)) {
    set_small(top.convert_to<std::int64_t>(), bottom.convert_to<std::int64_t>());
    return;
  }
  numerator_ = 0;
  denominator_ = 0;
  large_ = std::make_unique<Large>(std::move(value));
}

void Rational::set_small(std::int64_t numerator, std::int64_t denominator) {
  numerator_ = numerator;
  denominator_ = denominator;
  large_.reset();
}

// a/b + c/d with g = gcd(b, d): the numerator a(d/g) + c(b/g) has no factor in common with b/g nor
// d/g, so only its common divisor with g is left to cancel (Knuth, The Art of Computer Programming 2,
// 4.5.1). False, and nothing done, when a word is too small.
bool Rational::add_small(std::int64_t numerator, std::int64_t denominator) {
  std::int64_t sum = 0;
  if (denominator_ == 1 && denominator == 1) {
    if (__builtin_add_overflow(numerator_, numerator, &sum) || sum < -largest) return false;
    numerator_ = sum;
    return true;
  }
  const std::int64_t g = std::gcd(denominator_, denominator);
  std::int64_t first = 0;
  std::int64_t second = 0;
  if (__builtin_mul_overflow(numerator_, denominator / g, &first) ||
      __builtin_mul_overflow(numerator, denominator_ / g, &second) ||
      __builtin_add_overflow(first, second, &sum) || sum < -largest)
    return false;
  const std::int64_t common = std::gcd(sum, g);
  std::int64_t bottom = 0;
  if (__builtin_mul_overflow(denominator_ / g, denominator / common, &bottom)) return false;
  numerator_ = sum / common;
  denominator_ = bottom;
  return true;
}

bool Rational::multiply_small(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t left = denominator == 1 ? 1 : std::gcd(numerator_, denominator);
  const std::int64_t right = denominator_ == 1 ? 1 : std::gcd(numerator, denominator_);
  std::int64_t top = 0;
  std::int64_t bottom = 0;
  if (__builtin_mul_overflow(numerator_ / left, numerator / right, &top) || top < -largest ||
      __builtin_mul_overflow(denominator_ / right, denominator / left, &bottom))
    return false;
  numerator_ = top;
  denominator_ = bottom;
  return true;
}

Rational& Rational::operator+=(const Rational& other) {
  if (is_small() && other.is_small() && add_small(other.numerator_, other.denominator_))
    return *this;
  set_large(large() + other.large());
  return *this;
}

Rational& Rational::operator-=(const Rational& other) {
  if (is_small() && other.is_small() && add_small(-other.numerator_, other.denominator_))
    return *this;
  set_large(large() - other.large());
  return *this;
}

Rational& Rational::operator*=(const Rational& other) {
  if (is_small() && other.is_small() && multiply_small(other.numerator_, other.denominator_))
    return *this;
  set_large(large() * other.large());
  return *this;
}

Rational& Rational::operator/=(const Rational& other) {
  if (other.sign() == 0) throw std::overflow_error{"division by zero"};
  if (is_small() && other.is_small()) {
    const bool negative = other.numerator_ < 0;
    if (multiply_small(negative ? -other.denominator_ : other.denominator_,
                       negative ? -other.numerator_ : other.numerator_))
      return *this;
  }
  set_large(large() / other.large());
  return *this;
}

Rational operator-(const Rational& a) {
  Rational result = a;
  if (result.is_small())
    result.numerator_ = -result.numerator_;
  else
    *result.large_ = -*result.large_;
  return result;
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  if (a.is_small() && b.is_small()) {
    if (a.denominator_ == b.denominator_) return a.numerator_ <=> b.numerator_;
    std::int64_t left = 0;
    std::int64_t right = 0;
    if (!__builtin_mul_overflow(a.numerator_, b.denominator_, &left) &&
        !__builtin_mul_overflow(b.numerator_, a.denominator_, &right))
      return left <=> right;
  }
  if (a.sign() != b.sign()) return a.sign() <=> b.sign();
  const Integer left = numerator(a) * denominator(b);
  const int order = left.compare(numerator(b) * denominator(a));
  return order <=> 0;
}

Integer numerator(const Rational& a) {
  return a.large_ ? boost::multiprecision::numerator(*a.large_) : Integer{a.numerator_};
}

Integer denominator(const Rational& a) {
  return a.large_ ? boost::multiprecision::denominator(*a.large_) : Integer{a.denominator_};
}

Rational abs(const Rational& a) { return a.sign() < 0 ? -a : a; }

Integer floor(const Rational& a) {
  const Integer top = numerator(a);
  const Integer bottom = denominator(a);
  // Division of whole numbers in Boost cuts towards zero.
  Integer quotient = top / bottom;
  if (top < 0 && quotient * bottom != top) --quotient;
  return quotient;
}

std::ostream& operator<<(std::ostream& out, const Rational& a) {
  out << numerator(a);
  if (denominator(a) != 1) out << '/' << denominator(a);
  return out;
}

}  // namespace patchproof
