#include <recheck/interval.hpp>

#include <algorithm>

namespace recheck {

namespace {

constexpr unsigned few_digits = 64;
constexpr unsigned most_digits = 4096;

Interval operator*(const Interval& a, const Interval& b) {
  const auto [least, greatest] =
      std::minmax({Rational{a.lower * b.lower}, Rational{a.lower * b.upper},
                   Rational{a.upper * b.lower}, Rational{a.upper * b.upper}});
  return {least, greatest};
}

Interval power(const Interval& a, unsigned exponent) {
  Interval result{1, 1};
  for (unsigned k = 0; k < exponent; ++k) result = result * a;
  // A square is not negative, also where the base has both signs.
  if (exponent % 2 == 0 && result.lower < 0) result.lower = 0;
  return result;
}

Interval root(const Integer& radicand, unsigned digits) {
  const Integer scale = Integer{1} << digits;
  const Integer below = floor_of_root(radicand * scale * scale);
  return {Rational{below, scale}, Rational{Integer{below + 1}, scale}};
}

class Enclosures {
 public:
  Enclosures(const Box& box, unsigned digits, Field& field)
      : box_{box}, digits_{digits}, field_{field} {}

  std::optional<Interval> of(const Polynomial& a) {
    Interval total{0, 0};
    for (const auto& [monomial, coefficient] : a) {
      Interval part{coefficient, coefficient};
      for (const Power& p : monomial) {
        const std::optional<Interval> base = of(p.atom);
        if (!base) return std::nullopt;
        field_.meter().spend((1 + extra_words(base->lower) + extra_words(base->upper)) *
                             p.exponent);
        part = part * power(*base, p.exponent);
      }
      total.lower += part.lower;
      total.upper += part.upper;
    }
    return total;
  }

 private:
  std::optional<Interval> of(Atom atom) {
    const Meaning& meaning = field_.meaning(atom);
    if (meaning.kind == Meaning::Kind::root) return root(meaning.radicand, digits_);
    const auto found = box_.find(atom);
    if (found == box_.end()) return std::nullopt;
    return found->second;
  }

  const Box& box_;
  unsigned digits_;
  Field& field_;
};

}  // namespace

std::optional<Interval> enclosure(const Quotient& a, const Box& box, unsigned digits,
                                  Field& field) {
  Enclosures enclosures{box, digits, field};
  std::optional<Interval> result = enclosures.of(a.numerator);
  for (const auto& [factor, exponent] : a.denominator) {
    const std::optional<Interval> below = enclosures.of(factor);
    if (!result || !below || (below->lower <= 0 && below->upper >= 0)) return std::nullopt;
    const Interval inverse{1 / below->upper, 1 / below->lower};
    result = *result * power(inverse, exponent);
  }
  return result;
}

std::optional<int> sign(const Quotient& a, Field& field) {
  if (a.numerator.empty()) return 0;
  for (const Atom atom : atoms_within(a, field))
    if (field.meaning(atom).kind != Meaning::Kind::root) return std::nullopt;
  for (unsigned digits = few_digits; digits <= most_digits; digits *= 4) {
    const std::optional<Interval> found = enclosure(a, {}, digits, field);
    if (found && found->lower > 0) return 1;
    if (found && found->upper < 0) return -1;
  }
  throw Unsupported{"the sign of " + field.text(a)};
}

bool is_nonnegative(const Quotient& a, const Box& box, Field& field) {
  const std::optional<Interval> found = enclosure(a, box, few_digits, field);
  return found && found->lower >= 0;
}

bool is_nonzero(const Quotient& a, const Box& box, Field& field) {
  const std::optional<Interval> found = enclosure(a, box, few_digits, field);
  return found && (found->lower > 0 || found->upper < 0);
}

bool is_negative(const Quotient& a, const Box& box, Field& field) {
  const std::optional<Interval> found = enclosure(a, box, few_digits, field);
  return found && found->upper < 0;
}

}  // namespace recheck
