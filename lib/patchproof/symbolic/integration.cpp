#include <patchproof/symbolic/integration.hpp>

#include <stdexcept>

namespace patchproof::symbolic {

using GiNaC::ex;

ex integral(Ring& ring, const ex& integrand, unsigned variable, const ex& lower, const ex& upper) {
  const auto depends = [&](unsigned id) { return ring.atoms().within(id).contains(variable); };
  GiNaC::exvector parts;
  for (const auto& [powers, coefficient] : coefficients(integrand, ring.atoms(), depends)) {
    long exponent = 0;
    for (const auto& [id, power] : powers) {
      if (id != variable || power < 0) {
        throw std::domain_error{"the integral of something that is no polynomial"};
      }
      exponent = power;
    }
    const auto next = static_cast<unsigned long>(exponent) + 1;
    const ex ends = ring.sum({ring.power(upper, next), -ring.power(lower, next)});
    parts.push_back(
        ring.product(coefficient, ring.product(ends, GiNaC::numeric{1, static_cast<long>(next)})));
  }
  return ring.sum(parts);
}

}  // namespace patchproof::symbolic
