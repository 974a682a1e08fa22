// The beginning of the text of a polynomial, for messages.
#include <recheck/field.hpp>

namespace recheck {

namespace {

constexpr std::size_t longest = 120;

}  // namespace

std::string Field::text(Atom atom) const {
  const Meaning& of = meaning(atom);
  if (of.kind == Meaning::Kind::root) return "sqrt(" + of.radicand.str() + ")";
  std::string result = symbol(of.symbol).name;
  if (of.kind == Meaning::Kind::slot) return result + "#" + std::to_string(of.index);
  if (of.kind == Meaning::Kind::jet) {
    bool derived = false;
    std::string orders;
    for (const std::size_t order : of.orders) {
      orders += (orders.empty() ? "" : ",") + std::to_string(order);
      derived = derived || order > 0;
    }
    if (derived) result += "^(" + orders + ")";
    result += "(";
    for (std::size_t k = 0; k < of.arguments.size(); ++k)
      result += (k == 0 ? "" : ", ") + text(of.arguments[k]);
    result += ")";
  }
  if (symbol(of.symbol).type.dimension > 1) result += "." + std::to_string(of.index);
  return result;
}

std::string Field::text(const Polynomial& a) const {
  if (a.empty()) return "0";
  std::string result;
  for (auto term = a.rbegin(); term != a.rend(); ++term) {
    if (result.size() > longest) return result + " + ...";
    const bool negative = term->second < 0;
    result += result.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    const Rational size = abs(term->second);
    std::string factors;
    if (size != 1 || term->first.empty()) factors = to_text(size);
    for (const Power& power : term->first) {
      factors += (factors.empty() ? "" : "*") + text(power.atom);
      if (power.exponent > 1) factors += "^" + std::to_string(power.exponent);
    }
    result += factors;
  }
  return result;
}

std::string Field::text(const Quotient& a) const {
  if (a.denominator.empty()) return text(a.numerator);
  std::string result = "(" + text(a.numerator) + ")";
  for (const auto& [factor, exponent] : a.denominator) {
    result += "/(" + text(factor) + ")";
    if (exponent > 1) result += "^" + std::to_string(exponent);
  }
  return result;
}

}  // namespace recheck
