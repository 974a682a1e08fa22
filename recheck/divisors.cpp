#include <recheck/divisors.hpp>

#include <recheck/interval.hpp>

namespace recheck {

void Divisors::require(const Polynomials& divisors) const {
  for (const Polynomial& divisor : divisors)
    if (!is_shown(divisor))
      throw Rejection{"the divisor " + field_.text(divisor) + " is not shown not to be zero"};
}

bool Divisors::is_shown(const Polynomial& divisor) const {
  const std::optional<int> known = sign(as_quotient(divisor), field_);
  if (known) return *known != 0;
  Polynomial rest = divisor;
  Polynomial all = constant(1);
  for (const Polynomial& shown : shown_) {
    if (exact_quotient(shown, rest, field_.meter())) return true;
    while (const auto smaller = exact_quotient(rest, shown, field_.meter())) {
      rest = *smaller;
      if (number_in(rest)) return true;
    }
  }
  // What is left may be made of parts of several of them.
  for (const Polynomial& shown : shown_) {
    for (const Atom atom : atoms_in(shown)) {
      if (!atoms_in(rest).contains(atom)) continue;
      all = product(all, shown, field_.meter());
      break;
    }
  }
  return exact_quotient(all, rest, field_.meter()).has_value();
}

}  // namespace recheck
