#include <patchproof/algebra/simplest_between.hpp>

#include <utility>
#include <vector>

namespace patchproof {

namespace {

// The fraction whose continued fraction has these partial quotients.
Rational from_quotients(const std::vector<Integer>& quotients) {
  Integer top = 1;
  Integer bottom = 0;
  for (std::size_t i = quotients.size(); i-- > 0;) {
    Integer next = quotients[i] * top + bottom;
    bottom = std::move(top);
    top = std::move(next);
  }
  return Rational{top, bottom};
}

// The simplest fraction in an interval that has members, all of them positive: the first whole
// number in it, or n + 1/y where n is the whole part all members share and y the simplest of what
// is left. On numerators and denominators, so that nothing is ever cancelled; x/0 is infinity.
Rational simplest_positive(const Rational& low, bool low_strict,
                           const std::optional<Rational>& high, bool high_strict) {
  Integer low_top = numerator(low);
  Integer low_bottom = denominator(low);
  Integer high_top = high ? Integer{numerator(*high)} : Integer{1};
  Integer high_bottom = high ? Integer{denominator(*high)} : Integer{0};
  std::vector<Integer> quotients;
  while (true) {
    const Integer whole = low_top / low_bottom;
    const bool low_inside = !low_strict && whole * low_bottom == low_top;
    const Integer candidate = low_inside ? whole : Integer{whole + 1};
    const Integer left = candidate * high_bottom;
    if (left < high_top || (left == high_top && !high_strict)) {
      quotients.push_back(candidate);
      return from_quotients(quotients);
    }
    quotients.push_back(whole);
    low_top -= whole * low_bottom;
    high_top -= whole * high_bottom;
    std::swap(low_top, high_bottom);
    std::swap(low_bottom, high_top);
    std::swap(low_strict, high_strict);
  }
}

}  // namespace

std::optional<Rational> simplest_between(const std::optional<Rational>& low, bool low_strict,
                                         const std::optional<Rational>& high, bool high_strict) {
  if (low && high && (*low > *high || (*low == *high && (low_strict || high_strict)))) {
    return std::nullopt;
  }
  const bool reaches_down = !low || *low < 0 || (*low == 0 && !low_strict);
  const bool reaches_up = !high || *high > 0 || (*high == 0 && !high_strict);
  if (reaches_down && reaches_up) return Rational{0};
  if (!reaches_down) return simplest_positive(*low, low_strict, high, high_strict);
  std::optional<Rational> mirrored;
  if (low) mirrored = -*low;
  return -simplest_positive(-*high, high_strict, mirrored, low_strict);
}

}  // namespace patchproof
