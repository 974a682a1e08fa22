#include <patchproof/symbolic/basis_functions.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <patchproof/symbolic/elements.hpp>
#include <patchproof/symbolic/exact_number.hpp>
#include <patchproof/symbolic/substitution.hpp>

namespace patchproof::symbolic {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

constexpr int highest_degree = 4096;

// The polynomial in placeholder 0, at t.
ex at(Ring& ring, const ex& polynomial, const ex& t) {
  Replacements replacements;
  replacements.atoms[ring.atoms().id_of(placeholder(ring, 0))] = t;
  return Substitution{ring, std::move(replacements)}(polynomial);
}

void check(const BasisFunction& basis) {
  const std::vector<Rational>& knots = basis.knots;
  const auto size = static_cast<long>(knots.size());
  if (!std::is_sorted(knots.begin(), knots.end())) {
    throw std::domain_error{"the knots of a B-spline decrease"};
  }
  if (basis.degree < 0 || basis.index < 0 || basis.index + long{basis.degree} + 1 >= size) {
    throw std::domain_error{"a B-spline basis function that does not exist"};
  }
  if (basis.span < 0 || basis.span + 1L >= size ||
      knots[static_cast<std::size_t>(basis.span)] ==
          knots[static_cast<std::size_t>(basis.span) + 1]) {
    throw std::domain_error{"an empty knot span"};
  }
}

}  // namespace

ex bernstein(Ring& ring, int degree, int index, const ex& t) {
  if (index < 0 || index > degree) return 0;
  if (degree > highest_degree) throw OverBudget{"a Bernstein polynomial of too high a degree"};
  using Coefficients = std::vector<numeric>;
  // Entry i of row k is B_i^k by its coefficients, lowest first; only entries that reach the wanted
  // one are computed.
  std::vector<Coefficients> row(static_cast<std::size_t>(index) + 1);
  row[0] = {1};
  for (int k = 1; k <= degree; ++k) {
    const int first = std::max(0, index - (degree - k));
    for (int i = std::min(k, index); i >= first; --i) {
      const auto entry = static_cast<std::size_t>(i);
      Coefficients& own = row[entry];
      ring.spend(static_cast<std::uint64_t>(k));
      own.resize(static_cast<std::size_t>(k) + 1, 0);
      for (std::size_t power = own.size(); power-- > 0;) {
        if (power > 0) own[power] = own[power] - own[power - 1];
        if (power > 0 && i > 0) own[power] = own[power] + row[entry - 1][power - 1];
      }
    }
  }
  const ex x = placeholder(ring, 0);
  GiNaC::exvector parts;
  for (std::size_t power = 0; power < row.back().size(); ++power)
    parts.push_back(row.back()[power] * GiNaC::pow(x, numeric{static_cast<long>(power)}));
  return at(ring, ring.sum(parts), t);
}

ex bspline_piece(Ring& ring, const BasisFunction& basis, const ex& t) {
  check(basis);
  const auto first = static_cast<std::size_t>(basis.index);
  const auto count = static_cast<std::size_t>(basis.degree) + 2;
  const auto span = static_cast<std::size_t>(basis.span);
  std::vector<numeric> knots;
  for (std::size_t i = 0; i < count; ++i) knots.push_back(exact(basis.knots[first + i]));
  if (knots.front() == knots.back()) return 0;

  const numeric start = exact(basis.knots[span]);
  const numeric end = exact(basis.knots[span + 1]);
  const ex x = start + (end - start) * placeholder(ring, 0);
  // Entry j is the divided difference over j, ..., j+k; over equal knots a derivative by y.
  std::vector<ex> differences(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t j = 0; j + k < count; ++j) {
      if (knots[j + k] != knots[j]) {
        const ex change = ring.sum({differences[j + 1], -differences[j]});
        differences[j] = ring.product(change, 1 / (knots[j + k] - knots[j]));
      } else if (knots[j] < end) {
        differences[j] = 0;
      } else {
        const ex power = ring.power(ring.sum({knots[j], -x}), count - 2 - k);
        const numeric choices =
            GiNaC::binomial(numeric{basis.degree}, numeric{static_cast<long>(k)});
        differences[j] = ring.product(choices, power);
      }
    }
  }
  return at(ring, ring.product(knots.back() - knots.front(), differences.front()), t);
}

}  // namespace patchproof::symbolic
