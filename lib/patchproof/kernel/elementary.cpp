#include <patchproof/kernel/elementary.hpp>

#include <stdexcept>

namespace patchproof {

namespace {

// More parts than this would make polynomials nobody asked for.
constexpr long most_multiples = 240;

struct CosineAndSine {
  Fraction cosine;
  Fraction sine;
};

CosineAndSine rotated(const CosineAndSine& a, const CosineAndSine& b, Workspace& w) {
  const Fraction cosine = difference(product(a.cosine, b.cosine, w.budget),
                                     product(a.sine, b.sine, w.budget), w.budget);
  const Fraction sine = sum(product(a.cosine, b.sine, w.budget),
                            product(a.sine, b.cosine, w.budget), w.budget);
  return {normal_form(cosine, w), normal_form(sine, w)};
}

Fraction atom(Atom::Kind kind, const Fraction& argument, Workspace& w) {
  return Polynomial::variable(w.atoms.variable({kind, nullptr, 0, {}, {argument}}));
}

// How many parts of size base/parts the multiple is; asks for finer parts when it is not whole.
long multiples(const Rational& multiple, const Fraction& base, std::map<Fraction, Integer>& parts) {
  Integer& count = parts.try_emplace(base, 1).first->second;
  const Rational whole = multiple * count;
  if (denominator(whole) != 1) {
    count = lcm(count, Integer{denominator(multiple)});
    if (count > most_multiples) throw OutsideTheory{"an angle is cut into more than 240 parts"};
    throw FinerAngles{};
  }
  if (abs(numerator(whole)) > most_multiples)
    throw OutsideTheory{"a multiple of an angle is larger than 240 times its unit"};
  return static_cast<long>(numerator(whole));
}

CosineAndSine multiple_of(const Fraction& base, const Rational& multiple, Workspace& w) {
  const long count = multiples(multiple, base, w.angle_parts);
  const Fraction unit = product(base, Rational{1, w.angle_parts.at(base)}, w.budget);
  const CosineAndSine one{atom(Atom::Kind::cosine, unit, w), atom(Atom::Kind::sine, unit, w)};
  CosineAndSine result{Rational{1}, Rational{0}};
  CosineAndSine square = one;
  for (long rest = std::abs(count); rest > 0; rest /= 2) {
    if (rest % 2 == 1) result = rotated(result, square, w);
    if (rest > 1) square = rotated(square, square, w);
  }
  if (count < 0) result.sine = product(result.sine, Rational{-1}, w.budget);
  return result;
}

Fraction root_of_number(const Rational& number, Workspace& w);

// cos(k pi/12) for k = 0..6, see any table; sqrt(2), sqrt(3) as atoms.
Fraction cosine_of_twelfths(long k, Workspace& w) {
  const auto half_root = [&](long n) {
    return product(root_of_number(n, w), Rational{1, 2}, w.budget);
  };
  const auto quarter = [&](int sign) {
    const Fraction mixed = sum(root_of_number(6, w),
                               product(root_of_number(2, w), Rational{sign}, w.budget), w.budget);
    return product(mixed, Rational{1, 4}, w.budget);
  };
  switch (k) {
    case 0: return Rational{1};
    case 1: return quarter(1);
    case 2: return half_root(3);
    case 3: return half_root(2);
    case 4: return Rational{1, 2};
    case 5: return quarter(-1);
    default: return Rational{0};
  }
}

// cos(k pi/12) for every whole k.
Fraction cosine_of_any_twelfths(long k, Workspace& w) {
  long reduced = ((k % 24) + 24) % 24;
  if (reduced > 12) reduced = 24 - reduced;
  if (reduced <= 6) return cosine_of_twelfths(reduced, w);
  return product(cosine_of_twelfths(12 - reduced, w), Rational{-1}, w.budget);
}

CosineAndSine multiple_of_pi(const Rational& multiple, const Fraction& pi, Workspace& w) {
  // Modulo 2 first, so that large multiples stay exact and cheap.
  const Integer turns = numerator(multiple) / (denominator(multiple) * 2);
  const Rational rest = multiple - Rational{turns * 2};
  const Rational twelfths = rest * 12;
  if (denominator(twelfths) != 1) return multiple_of(pi, rest, w);
  const long k = static_cast<long>(numerator(twelfths));
  return {cosine_of_any_twelfths(k, w), cosine_of_any_twelfths(k - 6, w)};
}

CosineAndSine on_circle(const Fraction& angle, Workspace& w) {
  CosineAndSine result{Rational{1}, Rational{0}};
  if (!angle.is_polynomial()) {
    const Primitive p = primitive(angle.numerator());
    const Fraction base{p.polynomial, angle.denominator(), w.budget};
    return multiple_of(base, p.scale, w);
  }
  for (const auto& term : angle.numerator().terms()) {
    const auto& powers = term.monomial.powers();
    const Fraction base{Polynomial::from_terms({{term.monomial, 1}})};
    const bool just_pi = powers.size() == 1 && powers.front().exponent == 1 &&
                         w.atoms[powers.front().variable].kind == Atom::Kind::pi;
    result = rotated(result,
                     just_pi ? multiple_of_pi(term.coefficient, base, w)
                             : multiple_of(base, term.coefficient, w),
                     w);
  }
  return result;
}

// The square root of a whole number >= 0: a whole number times roots of primes. What is left
// after trial division counts as a prime: that loses relations between roots, never soundness.
Fraction root_of_integer(Integer number, Workspace& w) {
  Fraction result{Rational{1}};
  const auto take = [&](const Integer& prime, unsigned exponent) {
    for (unsigned k = 0; k < exponent / 2; ++k) result = product(result, Rational{prime}, w.budget);
    if (exponent % 2 == 1)
      result = product(result, atom(Atom::Kind::root, Rational{prime}, w), w.budget);
  };
  for (unsigned prime = 2; prime < 10'000 && Integer{prime} * prime <= number; ++prime) {
    unsigned exponent = 0;
    for (; number % prime == 0; number /= prime) ++exponent;
    take(prime, exponent);
  }
  const Integer root = sqrt(number);
  if (root * root == number) return product(result, Rational{root}, w.budget);
  take(number, 1);
  return result;
}

Fraction root_of_number(const Rational& number, Workspace& w) {
  if (number < 0) throw std::domain_error{"the square root of a negative number"};
  return product(root_of_integer(Integer{numerator(number)} * Integer{denominator(number)}, w),
                 Rational{1, denominator(number)}, w.budget);
}

}  // namespace

Fraction cosine(const Fraction& angle, Workspace& workspace) {
  return on_circle(angle, workspace).cosine;
}

Fraction sine(const Fraction& angle, Workspace& workspace) {
  return on_circle(angle, workspace).sine;
}

Fraction exponential(const Fraction& exponent, Workspace& w) {
  if (!exponent.is_polynomial()) return atom(Atom::Kind::exponential, exponent, w);
  Fraction result{Rational{1}};
  for (const auto& term : exponent.numerator().terms()) {
    const Fraction base{Polynomial::from_terms({{term.monomial, 1}})};
    const long count = multiples(term.coefficient, base, w.exponent_parts);
    const Fraction unit = product(base, Rational{1, w.exponent_parts.at(base)}, w.budget);
    result = product(result, power(atom(Atom::Kind::exponential, unit, w), count, w.budget),
                     w.budget);
  }
  return result;
}

Fraction square_root(const Fraction& radicand, Conditions& conditions, Workspace& w) {
  if (!radicand.is_polynomial())
    throw OutsideTheory{"the square root of a quotient; write sqrt(a*b)/b for sqrt(a/b)"};
  const Polynomial& polynomial = radicand.numerator();
  if (polynomial.is_constant()) return root_of_number(polynomial.constant(), w);
  conditions.insert({Condition::Kind::at_least_zero, polynomial});
  const Rational scale = content(polynomial);
  const Fraction rest = atom(Atom::Kind::root, scaled(polynomial, 1 / scale), w);
  return product(root_of_number(scale, w), rest, w.budget);
}

}  // namespace patchproof
