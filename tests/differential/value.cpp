#include <stdexcept>

#include "meaning.hpp"

namespace patchproof::differential {
namespace {

PlainPolynomial opposite(const PlainPolynomial& p) { return product(plain_number(-1), p); }

PlainFraction plus(const PlainFraction& a, const PlainFraction& b) {
  if (a.below == b.below) return {sum(a.above, b.above), a.below};
  return {sum(product(a.above, b.below), product(b.above, a.below)), product(a.below, b.below)};
}

PlainFraction times(const PlainFraction& a, const PlainFraction& b) {
  return {product(a.above, b.above), product(a.below, b.below)};
}

/// A polynomial with fractions in place of variables.
PlainFraction substituted(const PlainPolynomial& p,
                          const std::map<std::string, PlainFraction>& values) {
  PlainFraction result;
  for (const auto& [monomial, coefficient] : p) {
    PlainFraction term{plain_number(coefficient)};
    for (const auto& [name, exponent] : monomial) {
      const auto found = values.find(name);
      const PlainFraction factor =
          found == values.end() ? PlainFraction{plain_variable(name)} : found->second;
      term = times(term, {power(factor.above, exponent), power(factor.below, exponent)});
    }
    result = plus(result, term);
  }
  return result;
}

template <typename Change>
Value changed(const Value& of, const Change& change) {
  Value result{of.rows, of.columns, {}};
  for (const PlainFraction& entry : of.entries) result.entries.push_back(change(entry));
  return result;
}

bool is_single(const Value& value) { return value.entries.size() == 1; }

}  // namespace

Value value_of_number(const Rational& number) { return {1, 1, {{plain_number(number)}}}; }
Value value_of_variable(const std::string& name) { return {1, 1, {{plain_variable(name)}}}; }

Value plus(const Value& a, const Value& b) {
  // 0 is also the zero point and the zero matrix.
  if (is_single(a) && a.entries[0].above.empty()) return b;
  if (is_single(b) && b.entries[0].above.empty()) return a;
  if (a.rows != b.rows || a.columns != b.columns) throw std::logic_error{"sum of two shapes"};
  Value result{a.rows, a.columns, {}};
  for (std::size_t i = 0; i < a.entries.size(); ++i)
    result.entries.push_back(plus(a.entries[i], b.entries[i]));
  return result;
}

Value minus(const Value& a) {
  return changed(a, [](const PlainFraction& entry) {
    return PlainFraction{opposite(entry.above), entry.below};
  });
}

Value times(const Value& a, const Value& b) {
  if (is_single(b))
    return changed(a, [&](const PlainFraction& entry) { return times(entry, b.entries[0]); });
  if (is_single(a)) return times(b, a);
  if (a.columns != b.rows) throw std::logic_error{"product of shapes that do not fit"};
  Value result{a.rows, b.columns, {}};
  for (std::size_t i = 0; i < a.rows; ++i)
    for (std::size_t j = 0; j < b.columns; ++j) {
      PlainFraction entry;
      for (std::size_t k = 0; k < b.rows; ++k) entry = plus(entry, times(a.at(i, k), b.at(k, j)));
      result.entries.push_back(entry);
    }
  return result;
}

Value divided(const Value& a, const Value& b) {
  const PlainFraction& by = b.entries.at(0);
  if (by.above.empty()) throw std::domain_error{"division by zero"};
  return times(a, {1, 1, {{by.below, by.above}}});
}

Value differentiated(const Value& a, const std::string& variable) {
  return changed(a, [&](const PlainFraction& f) {
    const PlainPolynomial above = derivative(f.above, variable);
    const PlainPolynomial below = derivative(f.below, variable);
    if (below.empty()) return PlainFraction{above, f.below};
    return PlainFraction{sum(product(above, f.below), opposite(product(f.above, below))),
                         product(f.below, f.below)};
  });
}

Value substituted(const Value& a, const std::map<std::string, PlainFraction>& values) {
  return changed(a, [&](const PlainFraction& f) {
    const PlainFraction above = substituted(f.above, values);
    const PlainFraction below = substituted(f.below, values);
    if (below.above.empty()) throw std::domain_error{"division by zero"};
    return PlainFraction{product(above.above, below.below), product(above.below, below.above)};
  });
}

bool same(const Value& a, const Value& b) {
  const Value difference = plus(a, minus(b));
  for (const PlainFraction& entry : difference.entries)
    if (!entry.above.empty()) return false;
  return true;
}

std::string formal(std::size_t index) { return "$" + std::to_string(index + 1); }

Value applied(const Function& function, const std::vector<Value>& arguments) {
  std::map<std::string, PlainFraction> values;
  for (std::size_t i = 0; i < arguments.size(); ++i) values[formal(i)] = arguments[i].entries.at(0);
  return substituted(function.body, values);
}

}  // namespace patchproof::differential
