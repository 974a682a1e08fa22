#include <patchproof/mutation/numeric.hpp>

namespace patchproof {

namespace {

using syntax::Expression;
using Kind = Expression::Kind;

/// Larger powers are not data anybody types in.
constexpr int largest_exponent = 20;

std::optional<Rational> power_of(const Expression& e) {
  const std::optional<Rational> base = value_of(*e.operands[0]);
  const std::optional<Rational> exponent = value_of(*e.operands[1]);
  if (!base || !exponent || denominator(*exponent) != 1 || *exponent < 0 ||
      *exponent > largest_exponent)
    return std::nullopt;
  return power(*base, numerator(*exponent).convert_to<long>());
}

std::optional<Rational> product_of(const Expression& e) {
  Rational result = 1;
  for (std::size_t k = 0; k < e.operands.size(); ++k) {
    const std::optional<Rational> factor = value_of(*e.operands[k]);
    if (!factor || (e.signs[k] == '/' && *factor == 0)) return std::nullopt;
    if (e.signs[k] == '/')
      result /= *factor;
    else
      result *= *factor;
  }
  return result;
}

std::optional<Rational> sum_of(const Expression& e) {
  Rational result = 0;
  for (std::size_t k = 0; k < e.operands.size(); ++k) {
    const std::optional<Rational> summand = value_of(*e.operands[k]);
    if (!summand) return std::nullopt;
    if (e.signs[k] == '-')
      result -= *summand;
    else
      result += *summand;
  }
  return result;
}

}  // namespace

std::optional<Rational> value_of(const Expression& e) {
  switch (e.kind) {
    case Kind::number:
      return e.number;
    case Kind::negation:
      if (const std::optional<Rational> value = value_of(*e.operands[0])) return Rational{-*value};
      return std::nullopt;
    case Kind::sum:
      return sum_of(e);
    case Kind::product:
      return product_of(e);
    case Kind::power:
      return power_of(e);
    default:
      return std::nullopt;
  }
}

std::string as_text(const Span& span) {
  return span.source->text.substr(span.begin, span.end - span.begin);
}

}  // namespace patchproof
