#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <memory>
#include <utility>

namespace patchproof {

/// A whole number of any size.
using Integer = boost::multiprecision::cpp_int;

/// A built-in type of numbers; no truth values and no characters.
template <typename T>
concept MachineWord = std::integral<T> && !std::same_as<T, bool> && !std::same_as<T, char>;

/// An exact fraction of whole numbers of any size, always in lowest terms with a positive denominator.
///
/// Fractions of machine words are kept as two words and calculated with at once; what does not fit
/// is a `boost::multiprecision::cpp_rational`. A value has only one representation.
class Rational {
 public:
  Rational() = default;
  template <MachineWord Whole>
  Rational(Whole whole);  // NOLINT: a whole number is a fraction
  Rational(const Integer& whole);  // NOLINT
  /// @throws std::overflow_error when the denominator is 0.
  Rational(const Integer& numerator, const Integer& denominator);
  template <MachineWord Top, MachineWord Bottom>
  Rational(Top numerator, Bottom denominator)
      : Rational{std::move(Rational{numerator} /= Rational{denominator})} {}

  Rational(const Rational& other)
      : numerator_{other.numerator_},
        denominator_{other.denominator_},
        large_{other.large_ ? std::make_unique<Large>(*other.large_) : nullptr} {}
  Rational(Rational&& other) noexcept = default;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept = default;
  ~Rational() = default;

  Rational& operator+=(const Rational& other);
  Rational& operator-=(const Rational& other);
  Rational& operator*=(const Rational& other);
  /// @throws std::overflow_error when the other one is 0.
  Rational& operator/=(const Rational& other);

  friend Rational operator+(Rational a, const Rational& b) { return std::move(a += b); }
  friend Rational operator-(Rational a, const Rational& b) { return std::move(a -= b); }
  friend Rational operator*(Rational a, const Rational& b) { return std::move(a *= b); }
  friend Rational operator/(Rational a, const Rational& b) { return std::move(a /= b); }
  friend Rational operator-(const Rational& a);
  friend bool operator==(const Rational& a, const Rational& b) {
    return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_ &&
           (a.large_ == b.large_ || (a.large_ && b.large_ && *a.large_ == *b.large_));
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

  friend Integer numerator(const Rational& a);
  friend Integer denominator(const Rational& a);
  /// Whether numerator and denominator are machine words; then `words` has them.
  bool is_small() const { return large_ == nullptr; }
  struct Words {
    std::int64_t numerator;
    std::int64_t denominator;
  };
  /// Only for small ones.
  Words words() const { return {numerator_, denominator_}; }
  /// -1, 0 or 1.
  int sign() const { return large_ ? large_->sign() : (numerator_ > 0) - (numerator_ < 0); }

 private:
  using Large = boost::multiprecision::cpp_rational;
  static constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();

  Large large() const;
  void set_large(Large&& value);
  /// numerator / denominator > 0 in lowest terms, both not beyond `largest`.
  void set_small(std::int64_t numerator, std::int64_t denominator);
  bool add_small(std::int64_t numerator, std::int64_t denominator);
  bool multiply_small(std::int64_t numerator, std::int64_t denominator);

  // |numerator_| <= largest; both 0 when there is a large value.
  std::int64_t numerator_ = 0;
  std::int64_t denominator_ = 1;
  std::unique_ptr<Large> large_;
};

template <MachineWord Whole>
Rational::Rational(Whole whole) {
  if (std::in_range<std::int64_t>(whole) && static_cast<std::int64_t>(whole) >= -largest)
    numerator_ = static_cast<std::int64_t>(whole);
  else
    set_large(Large{whole});
}

Rational abs(const Rational& a);

/// The greatest whole number that is not above a.
Integer floor(const Rational& a);

/// As "p/q", or "p".
std::ostream& operator<<(std::ostream& out, const Rational& a);

}  // namespace patchproof
