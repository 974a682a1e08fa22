#include <patchproof/symbolic/exact_number.hpp>

#include <cln/cln.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace patchproof::symbolic {

namespace {

using GiNaC::numeric;

cln::cl_I whole(const Integer& number) { return cln::cl_I{number.str().c_str()}; }

// The check comes first: cln::the<cl_I> of anything else is undefined behaviour, not an exception.
cln::cl_I whole(const numeric& number) {
  if (!number.is_integer()) throw std::logic_error{"not a whole number"};
  return cln::the<cln::cl_I>(number.to_cl_N());
}

std::string whole_text(const numeric& number) {
  std::ostringstream out;
  out << whole(number);
  return out.str();
}

std::string rational_text(const numeric& number) {
  const std::string numerator = whole_text(number.numer());
  if (number.is_integer()) return numerator;
  return numerator + "/" + whole_text(number.denom());
}

std::size_t whole_bits(const numeric& number) { return cln::integer_length(whole(number)); }

std::size_t rational_bits(const numeric& number) {
  return std::max(whole_bits(number.numer()), whole_bits(number.denom()));
}

// Long numbers are searched less far, as each division costs more.
long trial_limit(const cln::cl_I& number) {
  return cln::integer_length(number) > 256 ? 1'000 : 50'000;
}

}  // namespace

numeric exact(const Rational& number) {
  const Integer top = numerator(number);
  const Integer bottom = denominator(number);
  return numeric{whole(top)} / numeric{whole(bottom)};
}

bool is_exact(const numeric& number) { return number.is_crational(); }

std::size_t bit_length(const numeric& number) {
  if (!is_exact(number)) throw std::logic_error{"not an exact number"};
  if (number.is_rational()) return rational_bits(number);
  return std::max(rational_bits(number.real()), rational_bits(number.imag()));
}

std::string text(const numeric& number) {
  if (!is_exact(number)) throw std::logic_error{"not an exact number"};
  if (number.is_rational()) return rational_text(number);
  const std::string imaginary = rational_text(number.imag()) + "*i";
  if (number.real().is_zero()) return "(" + imaginary + ")";
  const std::string sign = number.imag().is_positive() ? "+" : "";
  return "(" + rational_text(number.real()) + sign + imaginary + ")";
}

SquareRoot square_root(const numeric& number) {
  if (!number.is_rational() || !number.is_positive()) {
    throw std::domain_error{"the square root of a number that is not positive"};
  }
  // sqrt(p/q) = sqrt(p*q)/q
  const cln::cl_I denominator = whole(number.denom());
  cln::cl_I rest = whole(number.numer()) * denominator;
  cln::cl_I outside = 1;
  SquareRoot result;
  const long limit = trial_limit(rest);
  for (long prime = 2; prime <= limit && cln::cl_I{prime} * prime <= rest; ++prime) {
    bool odd = false;
    while (cln::zerop(cln::mod(rest, prime))) {
      rest = cln::exquo(rest, prime);
      if (odd) outside = outside * prime;
      odd = !odd;
    }
    if (odd) result.inside.push_back({numeric{prime}, true});
  }
  cln::cl_I root;
  if (cln::sqrtp(rest, &root)) {
    outside = outside * root;
  } else {
    result.inside.push_back({numeric{rest}, rest <= cln::cl_I{limit} * limit});
  }
  result.outside = numeric{outside} / numeric{denominator};
  return result;
}

}  // namespace patchproof::symbolic
