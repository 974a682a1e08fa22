#include <patchproof/language/knots.hpp>

#include <algorithm>

#include <patchproof/kernel/enclose.hpp>
#include <patchproof/kernel/evaluator.hpp>

namespace patchproof {

namespace {

// Knots are short expressions; what is not compared in so many steps counts as different.
constexpr int most_comparisons = 1000;

bool same(const Term& a, const Term& b, int& steps) {
  if (a.address() == b.address()) return true;
  if (++steps > most_comparisons) return false;
  if (a.operation() != b.operation() || a.children().size() != b.children().size()) return false;
  switch (a.operation()) {
    case Operation::number:
      return a.number() == b.number();
    case Operation::symbol:
      return a.symbol()->ordinal == b.symbol()->ordinal;
    case Operation::power:
      if (a.exponent() != b.exponent()) return false;
      break;
    case Operation::pi:
    case Operation::sum:
    case Operation::negation:
    case Operation::product:
    case Operation::quotient:
    case Operation::square_root:
      break;
    default:
      return false;
  }
  for (std::size_t k = 0; k < a.children().size(); ++k)
    if (!same(a.child(k), b.child(k), steps)) return false;
  return true;
}

}  // namespace

bool same_knot(const Term& a, const Term& b) {
  int steps = 0;
  return same(a, b, steps);
}

std::optional<int> order_of(const Term& a, const Term& b) {
  if (a.is_number() && b.is_number())
    return b.number() == a.number() ? 0 : b.number() < a.number() ? -1 : 1;
  constexpr std::uint64_t most_steps = 1'000'000;
  Limits limits;
  limits.steps = most_steps;
  Budget budget{limits};
  Workspace workspace{budget};
  try {
    Evaluator evaluator{workspace};
    const Fraction before = evaluator.value(a).components.front();
    const Fraction after = evaluator.value(b).components.front();
    const Fraction gap = normal_form(difference(after, before, budget), workspace);
    return certain_sign(gap, workspace.atoms, budget);
  } catch (const std::domain_error&) {
  } catch (const OutsideTheory&) {
  } catch (const FinerAngles&) {
  } catch (const OverBudget&) {
  }
  // Whatever kept it from being settled will show again where the spline is used.
  return std::nullopt;
}

std::vector<int> values_of(const Knots& knots) {
  std::vector<int> result;
  for (std::size_t k = 0; k < knots.size(); ++k)
    result.push_back(k == 0 ? 0 : result.back() + (same_knot(knots[k - 1], knots[k]) ? 0 : 1));
  return result;
}

bool are_numbers(const Knots& knots) {
  return std::all_of(knots.begin(), knots.end(), [](const Term& t) { return t.is_number(); });
}

std::vector<Rational> numbers_of(const Knots& knots) {
  std::vector<Rational> result;
  for (const Term& knot : knots) result.push_back(knot.number());
  return result;
}

std::vector<int> spans_of(const Knots& knots, int degree) {
  const std::vector<int> values = values_of(knots);
  std::vector<int> result;
  const auto last = static_cast<int>(knots.size()) - degree - 1;
  for (int k = degree; k < last; ++k)
    if (values[static_cast<std::size_t>(k)] != values[static_cast<std::size_t>(k) + 1])
      result.push_back(k);
  return result;
}

}  // namespace patchproof
