// pi, square root, sine, cosine and exponential in fixed-point whole numbers with a bound on the
// error that is carried along: no rounding is trusted, every one is counted.
//
// A Ball at precision p stands for the real numbers within (middle +- error) * 2^-p. Series are
// summed with every step cut towards zero, and stop at the first term that is cut to nothing; the
// comment at each series bounds both the cuts and the terms left out.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <patchproof/algebra/enclosure.hpp>

namespace patchproof {

namespace {

struct Ball {
  Integer middle;
  Integer error;
};

// x / 2^p, cut towards zero. Written out for negative numbers, where >> would round down.
Integer shifted(const Integer& x, unsigned p) {
  if (x < 0) return -Integer{Integer{-x} >> p};
  return x >> p;
}

// The binary digits before the point of |x|.
unsigned whole_bits(const Rational& x) {
  const Integer whole = boost::multiprecision::abs(numerator(x)) /
                        denominator(x);
  if (whole == 0) return 0;
  return static_cast<unsigned>(std::min<std::size_t>(boost::multiprecision::msb(whole) + 1, ~0U));
}

// x * 2^p cut towards zero: an error of less than 1.
Integer fixed_point(const Rational& x, unsigned p) {
  return Integer{numerator(x) << p} / denominator(x);
}

void require_bits(unsigned bits) {
  if (bits > most_bits) {
    throw std::domain_error{"more than " + std::to_string(most_bits) + " binary digits"};
  }
}

// A series at precision p has fewer than p terms, each with an error of at most 5, so that an
// error grows by at most bit_length(5 p) digits; p < 2^18 here.
constexpr unsigned guard = 28;

// The ball as an enclosure whose ends are multiples of 2^-(bits+4), p being larger than that.
Enclosure enclosure_of(const Ball& ball, unsigned p, unsigned bits) {
  const Integer scale = Integer{1} << p;
  return rounded(
      {Rational{ball.middle - ball.error, scale}, Rational{ball.middle + ball.error, scale}},
      bits + 4);
}

// arctan(1/q) = sum of (-1)^k / ((2k+1) q^(2k+1)).
//
// Cuts: the power has an error of less than 1 + 1/q^2 + ... < 2, divided by 2k+1 and cut again:
// less than 3 for each term. Left out: the series alternates and decreases, so less than the first
// term left out, whose power was cut to zero: less than 2.
Ball arctangent_of_inverse(unsigned q, unsigned p) {
  Integer power = (Integer{1} << p) / q;
  Integer sum = 0;
  unsigned k = 0;
  for (; power != 0; ++k) {
    const Integer term = power / (2 * k + 1);
    if (k % 2 == 0) {
      sum += term;
    } else {
      sum -= term;
    }
    power /= q * q;
  }
  return {sum, Integer{3} * k + 2};
}

// Machin's formula: pi = 16 arctan(1/5) - 4 arctan(1/239).
Ball pi_ball(unsigned p) {
  const Ball a = arctangent_of_inverse(5, p);
  const Ball b = arctangent_of_inverse(239, p);
  return {16 * a.middle - 4 * b.middle, 16 * a.error + 4 * b.error};
}

// sin r or cos r for 0 <= r < 1, by Taylor's series at 0: t -> t * r^2 / (d (d+1)).
//
// Cuts: let e be the error of a term, at most 4. r^2 < 1 has an error of at most 1, the term is
// less than 1, the product is cut, then divided by at least 2 and cut: at most (e + 2)/2 + 1 <= 4.
// Left out: the series alternates and decreases (r < 1), so at most the first term left out, which
// was cut to 0 and hence is at most 4. The caller adds the error of r itself.
Ball wave_series(const Integer& r, bool is_cosine, unsigned p) {
  const Integer square = shifted(r * r, p);
  Integer term = is_cosine ? Integer{1} << p : r;
  Integer sum = 0;
  unsigned d = is_cosine ? 1 : 2;
  unsigned count = 0;
  for (; term != 0; ++count, d += 2) {
    if (count % 2 == 0) {
      sum += term;
    } else {
      sum -= term;
    }
    term = shifted(term * square, p) / (std::uint64_t{d} * (d + 1));
  }
  return {sum, Integer{4} * count + 4};
}

// sin(x + shift * pi/2) at one number: x = k pi/2 + r with r about in [-pi/4, pi/4], then the
// quarter k + shift says which of +-sin r, +-cos r it is.
Enclosure wave_at(const Rational& x, unsigned shift, unsigned bits) {
  if (x == 0) return exactly(shift % 2 == 0 ? 0 : 1);
  const unsigned size = whole_bits(x);
  const unsigned p = bits + guard;
  // k < 2^size (as pi/2 > 1), and so k times the error of pi/2 needs `size` more digits.
  const unsigned fine = p + size + guard;
  const Ball pi = pi_ball(fine);
  const Integer fixed_x = fixed_point(x, fine);
  const Integer k = (abs(fixed_x) * 2 + pi.middle / 2) / pi.middle * (x < 0 ? -1 : 1);
  const Integer twice_rest = 2 * fixed_x - k * pi.middle;
  const Integer twice_error = 2 + abs(k) * pi.error;
  const Integer rest = shifted(twice_rest, fine - p + 1);
  // One for this cut, one for rounding up; sine and cosine are never steeper than 1.
  const Integer rest_error = shifted(twice_error, fine - p + 1) + 2;

  int quarter = static_cast<int>(Integer{k % 4}) + static_cast<int>(shift);
  quarter = ((quarter % 4) + 4) % 4;
  Ball value = wave_series(abs(rest), quarter % 2 == 1, p);
  value.error += rest_error;
  const bool odd_and_negative = quarter % 2 == 0 && rest < 0;
  if ((quarter >= 2) != odd_and_negative) value.middle = -value.middle;
  const Enclosure result = enclosure_of(value, p, bits);
  return {std::max(result.low, Rational{-1}), std::min(result.high, Rational{1})};
}

// Between extrema a wave is monotone, so its bounds are those of the ends, or +-1 where an
// extremum may be inside: there sin(x + shift pi/2) has x / (pi/2) + shift odd.
Enclosure wave(const Enclosure& x, unsigned shift, unsigned bits) {
  require_bits(bits);
  const unsigned size = std::max(whole_bits(x.low), whole_bits(x.high));
  if (size > most_bits) throw std::domain_error{"the argument of a sine or cosine is too large"};
  if (x.low == x.high) return wave_at(x.low, shift, bits);
  if (x.high - x.low >= 7) return {-1, 1};
  const Enclosure at_low = wave_at(x.low, shift, bits);
  const Enclosure at_high = wave_at(x.high, shift, bits);
  Enclosure result{std::min(at_low.low, at_high.low), std::max(at_low.high, at_high.high)};
  const unsigned p = bits + size + guard;
  const Enclosure half_pi =
      enclosure_of(pi_ball(p + guard), p + guard, p) * exactly(Rational{1, 2});
  const Enclosure quarters = rounded(x / half_pi, bits + guard);
  const Rational first = rounded({quarters.low, quarters.low}, 0).high;
  for (Rational n = first; n <= quarters.high; n += 1) {
    int phase = static_cast<int>(Integer{numerator(n) % 4});
    phase = ((phase + static_cast<int>(shift)) % 4 + 4) % 4;
    if (phase == 1) result.high = 1;
    if (phase == 3) result.low = -1;
  }
  return result;
}

// exp(r) for |r| <= 1/2 by Taylor's series at 0: t -> t * r / (k+1).
//
// Cuts: r has an error of less than 1, the term of at most 4 (0 at first), and |term| <= 1. The
// next one: (4 |r| + |term| + 1)/(k+1) + 1, which is at most 3, then 4 as |term| <= 1/2 and k >= 1.
// Left out: the first term left out was cut to 0, so it is at most 4; each later one is at most
// half of the one before, so all together at most 8.
Ball exponential_series(const Integer& r, unsigned p) {
  Integer term = Integer{1} << p;
  Integer sum = 0;
  unsigned count = 0;
  while (term != 0) {
    sum += term;
    ++count;
    term = shifted(term * r, p) / count;
  }
  return {sum, Integer{4} * count + 8};
}

// exp(x) = exp(x / 2^h)^(2^h) for |x| <= largest_exponent.
//
// Squaring doubles the relative error, so h squarings cost h binary digits, and the size of the
// result, less than 2^(3x/2), costs 3x/2 more for an absolute precision.
Enclosure exponential_at(const Rational& x, unsigned bits) {
  if (x == 0) return exactly(1);
  const unsigned halvings = whole_bits(x) + 8;
  const Rational size = rounded(exactly(x > 0 ? Rational{x * 3 / 2} : Rational{0}), 0).high;
  const unsigned growth = static_cast<unsigned>(numerator(size));
  const unsigned p = bits + growth + halvings + guard;
  const Integer scale = Integer{1} << halvings;
  Ball value = exponential_series(fixed_point(x / scale, p), p);
  for (unsigned i = 0; i < halvings; ++i) {
    // (m +- e)^2 = m^2 +- (2 m e + e^2); one for the cut of each.
    value.error = shifted(2 * value.middle * value.error + value.error * value.error, p) + 2;
    value.middle = shifted(value.middle * value.middle, p);
  }
  const Enclosure result = enclosure_of(value, p, bits);
  return {std::max(result.low, Rational{0}), result.high};
}

bool is_square(const Integer& number, Integer& root) {
  Integer remainder;
  root = boost::multiprecision::sqrt(number, remainder);
  return remainder == 0;
}

}  // namespace

Enclosure pi_enclosure(unsigned bits) {
  require_bits(bits);
  return enclosure_of(pi_ball(bits + guard), bits + guard, bits);
}

Enclosure square_root(const Enclosure& x, unsigned bits) {
  require_bits(bits);
  if (x.high < 0) throw std::domain_error{"the square root of a negative number"};
  Integer top;
  Integer bottom;
  if (x.low == x.high && is_square(numerator(x.low), top) &&
      is_square(denominator(x.low), bottom)) {
    return exactly(Rational{top, bottom});
  }
  // The whole root s of n has s <= sqrt(n) < s + 1, here with n = x * 4^p rounded outward.
  const unsigned p = bits + 4;
  const Enclosure scaled = rounded(
      {std::max(x.low, Rational{0}) * (Integer{1} << (2 * p)), x.high * (Integer{1} << (2 * p))},
      0);
  const Integer low = boost::multiprecision::sqrt(numerator(scaled.low));
  Integer high;
  if (!is_square(numerator(scaled.high), high)) ++high;
  const Integer scale = Integer{1} << p;
  return {Rational{low, scale}, Rational{high, scale}};
}

Enclosure sine(const Enclosure& x, unsigned bits) { return wave(x, 0, bits); }

Enclosure cosine(const Enclosure& x, unsigned bits) { return wave(x, 1, bits); }

Enclosure exponential(const Enclosure& x, unsigned bits) {
  require_bits(bits);
  const Rational largest{largest_exponent};
  if (x.high > largest) {
    throw std::domain_error{"the exponential of a number above " +
                            std::to_string(largest_exponent)};
  }
  const Rational least_high = std::max(x.high, Rational{-largest});
  if (x.low == least_high) return exponential_at(x.low, bits);
  const Rational low = x.low < -largest ? Rational{0} : exponential_at(x.low, bits).low;
  return {low, exponential_at(least_high, bits).high};
}

}  // namespace patchproof
