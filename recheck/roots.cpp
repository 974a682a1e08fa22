// Square roots of numbers as atoms: sqrt(12/5) is 2/5 * sqrt(3) * sqrt(5), where sqrt(3)^2 = 3.
// Roots of different primes are linearly independent over the rational numbers, with their
// products: a polynomial in them is zero only if it looks so.
#include <recheck/field.hpp>

namespace recheck {

namespace {

constexpr unsigned largest_tried = 10'000;

}  // namespace

Atom Field::root(const Integer& radicand) {
  const auto found = roots_.find(radicand);
  if (found != roots_.end()) return found->second;
  const Key key{Meaning::Kind::root, 0, roots_.size(), {}};
  const Atom atom = fresh(key, {Meaning::Kind::root, 0, 0, {}, {}, radicand, 0});
  roots_.emplace(radicand, atom);
  return atom;
}

Quotient Field::square_root(const Rational& given) {
  if (given < 0) throw Rejection{"the square root of the negative number " + to_text(given)};
  if (given == 0) return {};
  // sqrt(p/q) = sqrt(p*q)/q
  Integer rest = numerator(given) * denominator(given);
  Rational outside{1, denominator(given)};
  Quotient result = number(1);
  for (unsigned prime = 2; prime <= largest_tried && rest > 1; ++prime) {
    unsigned exponent = 0;
    meter_.spend(1 + rest.backend().size());
    for (; rest % prime == 0; rest /= prime) ++exponent;
    for (unsigned k = 0; k < exponent / 2; ++k) outside *= prime;
    if (exponent % 2 == 1) result = product(result, of_atom(root(prime)));
  }
  const Integer whole = floor_of_root(rest);
  if (whole * whole == rest) {
    outside *= Rational{whole};
  } else if (rest < Integer{largest_tried} * largest_tried) {
    result = product(result, of_atom(root(rest)));  // a prime: it has no factor up to its root
  } else {
    throw Unsupported{"the square root of a number with a large factor"};
  }
  return multiple(result, outside);
}

Polynomial Field::without_squares_of_roots(Polynomial a) {
  if (roots_.empty()) return a;
  Polynomial result;
  for (const auto& [monomial, coefficient] : a) {
    Monomial kept;
    Rational factor = coefficient;
    for (const Power& power : monomial) {
      const Meaning& of = meaning(power.atom);
      if (of.kind != Meaning::Kind::root) {
        kept.push_back(power);
        continue;
      }
      for (unsigned k = 0; k < power.exponent / 2; ++k) factor *= Rational{of.radicand};
      if (power.exponent % 2 == 1) kept.push_back({power.atom, 1});
    }
    add(result, kept, factor);
  }
  return result;
}

}  // namespace recheck
