#include <patchproof/symbolic/exponentials.hpp>

#include <stdexcept>

#include <patchproof/symbolic/elements.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

constexpr long largest_exponent = 1'000'000;

// GiNaC's value of a sine or cosine at a multiple of pi/12, made of numbers and square roots.
ex value_in_roots(Ring& ring, const ex& value) {
  if (is_a<numeric>(value)) return value;
  if (is_a<GiNaC::power>(value) && is_a<numeric>(value.op(0)) &&
      value.op(1).is_equal(numeric(1, 2))) {
    return square_root(ring, value.op(0));
  }
  const bool is_sum = is_a<GiNaC::add>(value);
  if (!is_sum && !is_a<GiNaC::mul>(value)) {
    throw std::logic_error{"an unexpected value of a sine or cosine"};
  }
  ex result = is_sum ? 0 : 1;
  for (std::size_t i = 0; i < value.nops(); ++i) {
    const ex part = value_in_roots(ring, value.op(i));
    result = is_sum ? ring.sum({result, part}) : ring.product(result, part);
  }
  return result;
}

// exp(i*pi*twelfths/12)
ex root_of_unity(Ring& ring, const numeric& twelfths) {
  const ex angle = GiNaC::mod(twelfths, 24) * GiNaC::Pi / 12;
  const ex real = value_in_roots(ring, GiNaC::cos(angle));
  const ex imaginary = value_in_roots(ring, GiNaC::sin(angle));
  return ring.sum({real, ring.product(GiNaC::I, imaginary)});
}

// exp(factor*m), or exp(i*factor*m), for a monomial m and a real factor.
ex exponential_of_monomial(Ring& ring, const numeric& factor, const Powers& powers,
                           bool imaginary) {
  if (factor.is_zero()) return 1;
  Atom atom;
  atom.kind = Atom::Kind::exponential;
  atom.arguments = {monomial(powers, ring.atoms())};
  atom.divisor = factor.denom();
  atom.imaginary = imaginary;
  const bool is_angle = imaginary && atom.arguments.front().is_equal(pi(ring));
  if (is_angle && (factor * 12).is_integer()) return root_of_unity(ring, factor * 12);
  if (GiNaC::abs(factor.numer()) > numeric{largest_exponent}) {
    throw OverBudget{"an exponent above a million"};
  }
  return GiNaC::pow(ring.atoms().symbol_for(atom), factor.numer());
}

// exp(unit*argument) for unit 1 or i.
ex exponential_of(Ring& ring, const ex& argument, const numeric& unit) {
  ex result = 1;
  for (const Summand& part : summands(canonical_argument(ring, argument), ring.atoms())) {
    const numeric factor = unit * part.coefficient;
    const ex growth = exponential_of_monomial(ring, factor.real(), part.powers, false);
    const ex turn = exponential_of_monomial(ring, factor.imag(), part.powers, true);
    result = ring.product(result, ring.product(growth, turn));
  }
  return result;
}

}  // namespace

ex exponential(Ring& ring, const ex& argument) { return exponential_of(ring, argument, 1); }

// exp(-i*x) is computed from -x: for sums with exact parts it is no power of exp(i*x).
ex sine(Ring& ring, const ex& argument) {
  const numeric i = ex_to<numeric>(GiNaC::I);
  const ex difference =
      ring.sum({exponential_of(ring, argument, i), -exponential_of(ring, argument, -i)});
  return ring.product(difference, 1 / (2 * GiNaC::I));
}

ex cosine(Ring& ring, const ex& argument) {
  const numeric i = ex_to<numeric>(GiNaC::I);
  const ex both = ring.sum({exponential_of(ring, argument, i), exponential_of(ring, argument, -i)});
  return ring.product(both, numeric(1, 2));
}

}  // namespace patchproof::symbolic
